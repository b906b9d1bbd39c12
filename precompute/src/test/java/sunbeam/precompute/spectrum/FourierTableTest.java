package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.jhdf.HdfFile;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import org.assertj.core.data.Offset;
import org.jtransforms.fft.DoubleFFT_1D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.Expansion.TaylorExpansion;

/** Tables of terms, powers of them, and their file. */
class FourierTableTest {
    @ParameterizedTest
    @CsvSource({
        "12, 10, 5, 0",
        "16, 8, 4, 0",
        "1, 13, 3, 0",
        "13, 1, 2, 0",
        "11, 9, 1, 0",
        "12, 10, 5, 40e-9",
        "16, 8, 4, 20e-9"
    })
    void everyTermIsTheDftOfItsPolynomial(int columns, int rows, int terms, double step) {
        HeightMap random = Surfaces.random(columns, rows, 40e-9, 300e-9, columns);
        HeightMap map = step == 0 ? random : random.map(height -> step * Math.rint(height / step));
        HeightMap heights = map;
        // Functions of the height are evaluated at samples or at levels.
        assertThat(heights.hasTooManyLevels()).isEqualTo(step == 0);
        TaylorExpansion expansion = new TaylorExpansion(HeightScale.mean(heights), terms, 5);
        Band bandX = Band.of(-2, 4);
        Band bandY = Band.of(-3, 1);
        FourierTable table = FourierTable.of(heights, expansion, bandX, bandY, done -> {});
        for (int n = 0; n < terms; n++) {
            for (int jy = bandY.first(); jy <= bandY.last(); jy++) {
                for (int jx = bandX.first(); jx <= bandX.last(); jx++) {
                    Complex expected = bin(map, expansion, n, jx, jy);
                    int at = (jy - bandY.first()) * bandX.count() + jx - bandX.first();
                    // Values of at most 1 rounded to float32: half a unit in the last place is 6e-8.
                    assertThat(table.real()[n][at]).isCloseTo((float) expected.getReal(), within(1e-7f));
                    assertThat(table.imaginary()[n][at]).isCloseTo((float) expected.getImaginary(), within(1e-7f));
                }
            }
        }
    }

    private static Complex bin(HeightMap map, TaylorExpansion expansion, int n, int jx, int jy) {
        Complex sum = Complex.ZERO;
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                double angle = 2 * Math.PI * ((double) jx * column / map.columns() - (double) jy * row / map.rows());
                double value = Math.pow(expansion.scale().scaled(map.at(column, row)), n);
                sum = sum.add(Complex.I.multiply(angle).exp().multiply(value));
            }
        }
        return sum.divide((double) map.columns() * map.rows());
    }

    private static final double MAXIMUM_PHASE = 6;
    private static final double TOLERANCE = 1e-6;

    /** The basis against |sum of terms|^2, with few terms (products of them) and with many. */
    @ParameterizedTest
    @CsvSource({"1, true", "3, true", "6, true", "20, true", "3, false", "6, false", "30, false"})
    void powersAreThoseOfTheTerms(int terms, boolean lowRank) {
        HeightMap map = Surfaces.random(20, 16, 40e-9, 300e-9, terms);
        HeightMap heights = map;
        HeightScale scale = HeightScale.mean(heights);
        Expansion expansion = lowRank
                ? LowRankExpansion.of(heights, scale, 0, MAXIMUM_PHASE, -1, terms)
                : new TaylorExpansion(scale, terms, MAXIMUM_PHASE);
        Band band = Band.of(-3, 4);
        FourierTable table = FourierTable.of(heights, expansion, band, band, done -> {});
        PowerSpectrum spectrum = PowerSpectrum.of(table, TOLERANCE);
        for (int bin = 0; bin < band.count() * band.count(); bin++) {
            double largest = 0;
            double worst = 0;
            for (double phase = 0.1; phase < MAXIMUM_PHASE; phase += 0.37) {
                double expected = power(table, expansion, phase, bin);
                double found = power(spectrum, phase, bin);
                largest = Math.max(largest, expected);
                worst = Math.max(worst, Math.abs(found - expected));
            }
            // Ten times: one row in a hundred misses the tolerance. Twice: the worst phase instead of the root mean
            // square.
            assertThat(worst).as("bin %d", bin).isCloseTo(0, within(20 * TOLERANCE * (largest + 1e-10)));
        }
    }

    /** All levels of a table may be open at a time; a copy for each would take as many times the memory. */
    @Test
    void allUsersOfASpectrumShareItTransposed() {
        PowerSpectrum.Axis x = new PowerSpectrum.Axis(1e-6, 0, 3);
        PowerSpectrum.Axis y = new PowerSpectrum.Axis(1e-6, 0, 2);
        double[][] terms = {{1, 2, 3, 4, 5, 6}};
        PowerSpectrum spectrum = PowerSpectrum.of(new HeightScale(0, 1e-6), null, x, y, terms, TOLERANCE);
        PowerSpectrum transposed = spectrum.transposed();
        assertThat(spectrum.transposed()).isSameAs(transposed);
        assertThat(transposed.transposed()).isSameAs(spectrum);
        assertThat(transposed.terms(0, 1)[0]).containsExactly(1, 4, 2, 5, 3, 6);
    }

    private static double power(PowerSpectrum spectrum, double phase, int bin) {
        double[] functions = spectrum.coefficients().at(phase);
        return IntStream.range(0, functions.length)
                .mapToDouble(n -> functions[n] * spectrum.powers()[bin * spectrum.stride() + n])
                .sum();
    }

    private static double power(FourierTable table, Expansion expansion, double phase, int bin) {
        double[] coefficients = expansion.coefficients(phase);
        Complex sum = Complex.ZERO;
        for (int n = 0; n < coefficients.length; n++) {
            Complex term = new Complex(table.real()[n][bin], table.imaginary()[n][bin]);
            sum = sum.add(term.multiply(table.expansion().kind().turn(n)).multiply(coefficients[n]));
        }
        return sum.multiply(sum.conjugate()).getReal();
    }

    @TempDir
    Path folder;

    /** The format of docs/conventions.md. */
    @Test
    void filesDescribeTheirTableCompletely() {
        HeightMap heights = Surfaces.random(12, 10, 50e-9, 300e-9, 1);
        HeightScale scale = HeightScale.midRange(heights);
        LowRankExpansion expansion = LowRankExpansion.of(heights, scale, 0, 5, 1e-3, Integer.MAX_VALUE);
        FourierTable table = FourierTable.of(heights, expansion, Band.of(-2, 3), Band.of(-4, 1), done -> {});
        Path file = folder.resolve("table.h5");

        table.write(file, "test patch µ", "digest");

        try (HdfFile hdf = new HdfFile(file)) {
            float[][][][] terms = (float[][][][]) hdf.getDatasetByPath("terms").getData();
            assertThat(terms).hasDimensions(table.terms(), 2);
            for (int n = 0; n < table.terms(); n++) {
                assertThat(terms[n][0][5][0]).isEqualTo(table.real()[n][5 * 6]);
                assertThat(terms[n][1][1][3]).isEqualTo(table.imaginary()[n][6 + 3]);
            }
            float[][] coefficients =
                    (float[][]) hdf.getDatasetByPath("coefficients").getData();
            assertThat(coefficients).hasNumberOfRows(expansion.terms());
            assertThat(coefficients[1][0]).isEqualTo((float) expansion.coefficients(0)[1]);
            assertThat(hdf.getAttribute("patch_name").getData()).isEqualTo("test patch µ");
            assertThat(hdf.getAttribute("pitch_y_metres").getData()).isEqualTo(50e-9);
            assertThat(hdf.getAttribute("first_bin_y").getData()).isEqualTo(-4);
            assertThat(hdf.getAttribute("expansion").getData()).isEqualTo("lowrank");
            assertThat(hdf.getAttribute("height_half_range_metres").getData()).isEqualTo(scale.halfRange());
        }
    }

    // Sums of at most 1332 values of at most 1, normalised by 1/N: rounding and what kernels leave stay near 1e-15.
    private static final Offset<Double> ROUNDING = within(2e-14);

    private static double[] random(int length) {
        return new SplittableRandom(length).doubles(length, -1, 1).toArray();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5, 8, 12, 64, 97, 100, 256, 333, 1000, 1009, 1332})
    void anyLengthAgreesWithJTransforms(int length) {
        Band band = Band.of(-7, length + 3);
        BandTransform2d.Line transform = new BandTransform2d.Line(length, band);
        ComplexVector work = transform.workspace();
        double[] interleaved = random(2 * length);
        for (int n = 0; n < length; n++) {
            work.real()[n] = interleaved[2 * n];
            work.imaginary()[n] = interleaved[2 * n + 1];
        }
        new DoubleFFT_1D(length).complexInverse(interleaved, true);
        ComplexVector result = ComplexVector.zeros(band.count());
        transform.transform(work, result, 0, 1);
        for (int m = 0; m < band.count(); m++) {
            int bin = Math.floorMod(band.first() + m, length);
            assertThat(result.real()[m]).as("bin %d", bin).isCloseTo(interleaved[2 * bin], ROUNDING);
            assertThat(result.imaginary()[m]).as("bin %d", bin).isCloseTo(interleaved[2 * bin + 1], ROUNDING);
        }
    }
}
