package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.jtransforms.fft.DoubleFFT_1D;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BandTransform2dTest {
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

    @ParameterizedTest
    @CsvSource({"16, 8, 7, 3", "15, 9, 7, 4", "12, 7, 3, 2", "7, 12, 3, 5", "1, 6, 0, 2", "6, 1, 2, 0", "9, 2, 4, 0"})
    void powersAreTheSquaresOfTheComplexTransform(int columns, int rows, int reachX, int reachY) {
        double[] field = random(columns * rows);
        BandTransform2d transform =
                new BandTransform2d(columns, rows, Band.of(-reachX, reachX), Band.of(-reachY, reachY));
        double[] powers =
                transform.powers((row, samples) -> System.arraycopy(field, row * columns, samples, 0, columns));
        ComplexVector bins =
                transform.transform((row, real, imaginary) -> System.arraycopy(field, row * columns, real, 0, columns));
        assertThat(powers).hasSize(bins.length());
        for (int i = 0; i < powers.length; i++) {
            double expected = bins.real()[i] * bins.real()[i] + bins.imaginary()[i] * bins.imaginary()[i];
            // Both round, at 1e-16 of values up to 1, in some ten steps of the transform.
            assertThat(powers[i]).isCloseTo(expected, within(1e-14));
        }
    }
}
