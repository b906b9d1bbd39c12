package sunbeam.precompute.fourier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class PowerSpectrum2dTest {
    @ParameterizedTest
    @CsvSource({"16, 8, 7, 3", "15, 9, 7, 4", "12, 7, 3, 2", "7, 12, 3, 5", "1, 6, 0, 2", "6, 1, 2, 0", "9, 2, 4, 0"})
    void isTheSquareOfTheComplexTransform(int columns, int rows, int reachX, int reachY) {
        Random random = new Random(5);
        double[] field = random.doubles((long) columns * rows, -1, 1).toArray();
        double[] power = new PowerSpectrum2d(columns, rows, reachX, reachY)
                .power((row, samples) -> System.arraycopy(field, row * columns, samples, 0, columns));
        ComplexVector bins = new BandTransform2d(columns, rows, Band.of(-reachX, reachX), Band.of(-reachY, reachY))
                .transform((row, real, imaginary) -> System.arraycopy(field, row * columns, real, 0, columns));
        assertThat(power).hasSize(bins.length());
        for (int i = 0; i < power.length; i++) {
            double expected = bins.real()[i] * bins.real()[i] + bins.imaginary()[i] * bins.imaginary()[i];
            // Both round, at 1e-16 of values up to 1, in some ten steps of the transform.
            assertThat(power[i]).isCloseTo(expected, within(1e-14));
        }
    }
}
