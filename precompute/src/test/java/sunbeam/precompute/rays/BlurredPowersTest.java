package sunbeam.precompute.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.optics.CoherenceWindow;

class BlurredPowersTest {
    private static final double PERIOD = 65e-6;
    private static final int BINS = 61;
    private static final double REACH = 3.3;

    /** A plane of two terms, in which some bins are a million times as bright as others. */
    private static BinPlane plane() {
        SplittableRandom random = new SplittableRandom(8);
        double[][] fields = new double[2][BINS * BINS];
        for (double[] field : fields) {
            for (int i = 0; i < field.length; i++) {
                field[i] = Math.pow(10, -6 * random.nextDouble());
            }
        }
        return BinPlane.of(PERIOD, PERIOD, -30, -30, BINS, BINS, fields);
    }

    /** One over 2 pi sigma is the deviation in cycles per metre, and the length is four sigma. */
    private static CoherenceWindow window(double spacing) {
        return CoherenceWindow.ofCoherenceLength(4 * PERIOD * spacing / (2 * Math.PI));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.39, 0.28})
    void blurredBinsAreTheSumsOfGaussians(double spacing) {
        BlurredPowers exact = BlurredPowers.of(plane(), window(spacing), 6, false);
        BlurredPowers interpolated = BlurredPowers.of(plane(), window(spacing), REACH, true);
        double[] frequencies = new double[200];
        for (int i = 0; i < frequencies.length; i++) {
            frequencies[i] = 20 * i / (frequencies.length * PERIOD);
        }
        for (double angle = 0; angle < 6; angle += 0.7) {
            double[][] expected = new double[2][frequencies.length];
            double[][] terms = new double[2][frequencies.length];
            exact.alongRay(Math.cos(angle), Math.sin(angle), frequencies, expected);
            interpolated.alongRay(Math.cos(angle), Math.sin(angle), frequencies, terms);
            for (int m = 0; m < 2; m++) {
                for (int i = 0; i < frequencies.length; i++) {
                    // B-splines err by 6e-4 of a bin at most at the widest spacing, and bins have both signs of it; the
                    // reach
                    // leaves out 2e-5 of each.
                    assertThat(terms[m][i]).isCloseTo(expected[m][i], within(2e-3 * expected[m][i] + 1e-4));
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.28})
    void beyondThePlaneThereIsNothing(double spacing) {
        BlurredPowers powers = BlurredPowers.of(plane(), window(spacing), REACH, true);
        double[][] terms = new double[2][2];
        powers.alongRay(1, 0, new double[] {31.2 / PERIOD, 500 / PERIOD}, terms);
        assertThat(terms[0][0]).isFinite();
        assertThat(terms[0][1]).isZero();
    }
}
