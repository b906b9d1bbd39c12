package sunbeam.precompute.radial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.spectrum.PowerSpectrum;

class RayBatchTest {
    private static final double PERIOD_X = 65e-6;
    private static final double PERIOD_Y = 50e-6;
    private static final int REACH_IN_BINS = 60;
    private static final int BINS = 2 * REACH_IN_BINS + 1;
    private static final double REACH = 4.8;
    private static final int TERMS = 5;
    private static final RayBatch.Knots KNOTS = new RayBatch.Knots(Math.log(15 / PERIOD_X), 0.02, 50);
    // Of a B-spline, where it is summed for comparison.
    private static final int STEPS = 400;

    /** Terms' spectra with some bins a million times as bright as others. */
    private static PowerSpectrum plane() {
        SplittableRandom random = new SplittableRandom(8);
        double[][] fields = new double[TERMS][BINS * BINS];
        for (double[] field : fields) {
            for (int i = 0; i < field.length; i++) {
                field[i] = Math.pow(10, -6 * random.nextDouble());
            }
        }
        return PowerSpectrum.of(
                new HeightScale(0, 1e-6),
                CoefficientTable.sampled(0, 1, 1, zeta -> new double[fields.length]),
                new PowerSpectrum.Axis(PERIOD_X, -REACH_IN_BINS, BINS),
                new PowerSpectrum.Axis(PERIOD_Y, -REACH_IN_BINS, BINS),
                fields,
                1e-4);
    }

    /** One over 2 pi sigma is the deviation in cycles per meter, and the length is four sigma. */
    private static CoherenceWindow window(double sigmaBins) {
        return CoherenceWindow.ofCoherenceLength(4 * PERIOD_X / (2 * Math.PI * sigmaBins));
    }

    private static WindowedSpectrum powers(double sigmaBins) {
        return new WindowedSpectrum(plane(), window(sigmaBins), REACH, false);
    }

    private static double spline(double distance) {
        double x = Math.abs(distance);
        return x < 1 ? 2.0 / 3 - x * x + x * x * x / 2 : Math.pow(2 - x, 3) / 6;
    }

    /** Averages by definition, of sums over all relevant bins at many frequencies. */
    private static double[] exact(WindowedSpectrum powers, double angle) {
        double[] averages = new double[KNOTS.count() * powers.stride()];
        WindowedSpectrum.Sums sums = powers.sums();
        for (int knot = 0; knot < KNOTS.count(); knot++) {
            for (int i = 0; i < STEPS - 1; i++) {
                double distance = 4.0 * (i + 1) / STEPS - 2;
                double frequency = Math.exp(KNOTS.first() + (knot + distance) * KNOTS.spacing());
                double[] terms = sums.at(Math.cos(angle) * frequency, Math.sin(angle) * frequency);
                for (int m = 0; m < TERMS; m++) {
                    averages[knot * powers.stride() + m] += 4.0 / STEPS * spline(distance) * terms[m];
                }
            }
        }
        return averages;
    }

    /** A bell of B-splines around a knot, as narrow as a color matching function. */
    private static double bell(double[] averages, int stride, int middle, int term) {
        double sum = 0;
        for (int knot = 0; knot < KNOTS.count(); knot++) {
            sum += Math.exp(-Math.pow((knot - middle) / 4.0, 2)) * averages[knot * stride + term];
        }
        return sum;
    }

    // As wide relative to bins as the window of a whole scan, and narrower; B-splines are 0.3 to 0.8 bins apart.
    @ParameterizedTest
    @ValueSource(doubles = {0.45, 0.64, 1.8})
    void averagesAreThoseOfTheSumsOverBins(double sigmaBins) {
        WindowedSpectrum powers = powers(sigmaBins);
        double[] averages = new double[powers.stride() * KNOTS.count()];
        // All directions, with both axes and diagonals, and rays at the ends of batches.
        for (double middle = -0.2; middle < 6.3; middle += 0.4) {
            double first = middle - 0.18;
            boolean isBatch = WindowedSpectrum.isAlongX(first) == WindowedSpectrum.isAlongX(middle + 0.18);
            double last = isBatch ? middle + 0.18 : first;
            RayBatch batch = powers.batch(first, last, KNOTS);
            for (double angle : new double[] {first, 0.3 * first + 0.7 * last, last}) {
                batch.averages(angle, averages);
                double[] exact = exact(powers, angle);
                for (int knot = 10; knot < KNOTS.count() - 10; knot++) {
                    for (int m = 0; m < TERMS; m++) {
                        double expected = bell(exact, powers.stride(), knot, m);
                        // Error of the trapezoid rule, 5e-8, and of B-splines no wider than some steps.
                        assertThat(bell(averages, powers.stride(), knot, m))
                                .as("angle %.2f, knot %d", angle, knot)
                                .isCloseTo(expected, within(2e-4 * expected));
                    }
                }
            }
        }
    }

    @Test
    void beyondThePlaneThereIsNothing() {
        WindowedSpectrum powers = powers(0.64);
        RayBatch.Knots beyond = new RayBatch.Knots(Math.log(80 / PERIOD_X), 0.02, 30);
        double[] averages = new double[powers.stride() * beyond.count()];
        powers.batch(0, 0.1, beyond).averages(0.05, averages);
        assertThat(averages).containsOnly(0);
    }
}
