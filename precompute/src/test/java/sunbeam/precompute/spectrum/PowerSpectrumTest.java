package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

class PowerSpectrumTest {
    private static final double MAXIMUM_PHASE = 6;
    private static final double TOLERANCE = 1e-6;

    /** The basis against |sum of terms|^2, with few terms (products of them) and with many. */
    @ParameterizedTest
    @CsvSource({"1, true", "3, true", "6, true", "20, true", "3, false", "6, false", "30, false"})
    void powersAreThoseOfTheTerms(int terms, boolean lowRank) {
        HeightMap map = Surfaces.random(20, 16, 40e-9, 300e-9, terms);
        HeightLevels heights = HeightLevels.of(map);
        HeightScale scale = HeightScale.mean(heights);
        Expansion expansion = lowRank
                ? LowRankExpansion.ofTerms(heights, scale, 0, MAXIMUM_PHASE, terms)
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
        return sum.getReal() * sum.getReal() + sum.getImaginary() * sum.getImaginary();
    }
}
