package sunbeam.precompute.fourier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.jtransforms.fft.DoubleFFT_1D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BandTransformTest {
    // Sums of at most 1332 values of at most 1, normalised by 1/N: rounding and what kernels leave stay near 1e-15.
    private static final Offset<Double> ROUNDING = within(2e-14);

    private static ComplexVector randomInto(ComplexVector target, int length, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int n = 0; n < length; n++) {
            target.real()[n] = random.nextDouble(-1, 1);
            target.imaginary()[n] = random.nextDouble(-1, 1);
        }
        return target;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5, 8, 12, 64, 97, 100, 128, 211, 333})
    void anyLengthAgreesWithTheNaiveDft(int length) {
        Band band = Band.of(-7, length + 3);
        BandTransform transform = new BandTransform(length, band);
        ComplexVector work = randomInto(transform.workspace(), length, length);
        ComplexVector original = randomInto(ComplexVector.zeros(length), length, length);
        ComplexVector result = ComplexVector.zeros(band.count());
        transform.transform(work, result, 0, 1);
        for (int m = 0; m < band.count(); m++) {
            double[] expected = NaiveDft.at(original, length, (double) (band.first() + m) / length);
            assertThat(result.real()[m]).as("length %d bin %d", length, m).isCloseTo(expected[0] / length, ROUNDING);
            assertThat(result.imaginary()[m])
                    .as("length %d bin %d", length, m)
                    .isCloseTo(expected[1] / length, ROUNDING);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {256, 1000, 1332, 1009})
    void longLengthsAgreeWithJTransforms(int length) {
        BandTransform transform = new BandTransform(length, Band.of(0, length - 1));
        ComplexVector work = randomInto(transform.workspace(), length, 7);
        double[] interleaved = new double[2 * length];
        for (int n = 0; n < length; n++) {
            interleaved[2 * n] = work.real()[n];
            interleaved[2 * n + 1] = work.imaginary()[n];
        }
        new DoubleFFT_1D(length).complexInverse(interleaved, true);
        ComplexVector result = ComplexVector.zeros(length);
        transform.transform(work, result, 0, 1);
        for (int m = 0; m < length; m++) {
            assertThat(result.real()[m]).as("length %d bin %d", length, m).isCloseTo(interleaved[2 * m], ROUNDING);
            assertThat(result.imaginary()[m])
                    .as("length %d bin %d", length, m)
                    .isCloseTo(interleaved[2 * m + 1], ROUNDING);
        }
    }

    @Test
    void twoDimensionsFollowTheConventionOfAMapSeenFromAbove() {
        int columns = 12;
        int rows = 7;
        Band bandX = Band.of(-3, 5);
        Band bandY = Band.of(-4, 2);
        double[] re = new double[columns * rows];
        double[] im = new double[columns * rows];
        randomInto(new ComplexVector(re, im), re.length, 11);
        ComplexVector bins = new BandTransform2d(columns, rows, bandX, bandY).transform((row, real, imaginary) -> {
            System.arraycopy(re, row * columns, real, 0, columns);
            System.arraycopy(im, row * columns, imaginary, 0, columns);
        });
        for (int jy = bandY.first(); jy <= bandY.last(); jy++) {
            for (int jx = bandX.first(); jx <= bandX.last(); jx++) {
                double sumReal = 0;
                double sumImaginary = 0;
                for (int row = 0; row < rows; row++) {
                    for (int column = 0; column < columns; column++) {
                        double y = -row;
                        double angle = 2 * Math.PI * ((double) jx * column / columns + jy * y / rows);
                        int i = row * columns + column;
                        sumReal += re[i] * Math.cos(angle) - im[i] * Math.sin(angle);
                        sumImaginary += re[i] * Math.sin(angle) + im[i] * Math.cos(angle);
                    }
                }
                int at = (jy - bandY.first()) * bandX.count() + jx - bandX.first();
                assertThat(bins.real()[at]).as("bin %d %d", jx, jy).isCloseTo(sumReal / re.length, ROUNDING);
                assertThat(bins.imaginary()[at]).as("bin %d %d", jx, jy).isCloseTo(sumImaginary / re.length, ROUNDING);
            }
        }
    }
}
