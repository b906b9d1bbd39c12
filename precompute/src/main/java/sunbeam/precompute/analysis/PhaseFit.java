package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.stat.StatUtils;

/**
 * How fast a phase turns, and how well that is known where nobody knows what disturbs it. Lines that stray from the
 * places of an exact grating each by themselves leave white noise in the phase; gaps that deviate each by themselves
 * leave a random walk, whose slope is known far worse. The series itself says how much of both there is: for a range of
 * ratios between them the slope is found by generalised least squares, and the answers are averaged with the weights of
 * their restricted likelihoods (D. A. Harville, J. Am. Stat. Assoc. 72, 1977). Noise of neighbouring places is correlated
 * as their windows overlap.
 */
final class PhaseFit {
    /** With fewer a slope, a curvature and their uncertainties cannot be told apart. */
    static final int FEWEST = 5;

    private static final int MOST = 60;
    // Variance of the walk per place over that of white noise.
    private static final double SMALLEST_RATIO = 1e-2;
    private static final double LARGEST_RATIO = 1e3;
    private static final int RATIOS = 11;
    // Below, the walk is lost in the noise of single places.
    private static final double WANDERING_RATIO = 0.1;
    // Over how many places gaps deviate together.
    private static final double[] MEMORIES = {0, 2, 6};
    // Of the integral over the window's overlap with itself.
    private static final int NODES = 24;

    private final double[] places;
    private final double[] phases;
    private final RealMatrix white;
    private final List<RealMatrix> walks = new ArrayList<>();

    /**
     * One coefficient under one ratio.
     *
     * @param logWeight restricted log-likelihood
     * @param value best
     * @param error standard error
     * @param freedom degrees of freedom of its Student distribution
     */
    private record Answer(double logWeight, double value, double error, int freedom) {}

    /**
     * What is known of a coefficient.
     *
     * @param low of the interval that holds it with a probability
     * @param median of its distribution
     * @param high of the interval
     */
    record Interval(double low, double median, double high) {}

    PhaseFit(PhaseSeries series) {
        int stride = Math.max(1, (int) Math.ceil((double) series.size() / MOST));
        int count = (series.size() + stride - 1) / stride;
        places = new double[count];
        phases = new double[count];
        double mean = StatUtils.mean(series.strengths());
        double[] strengths = new double[count];
        for (int i = 0; i < count; i++) {
            places[i] = i * stride - 0.5 * (series.size() - 1);
            phases[i] = series.phases()[i * stride];
            strengths[i] = relative(series.strengths()[i * stride], mean);
        }
        white = matrix(
                count,
                (i, j) -> overlap(Math.abs(i - j) * stride / series.window()) / (strengths[i] * strengths[j])
                        + (i == j ? 1e-6 : 0));
        for (double memory : MEMORIES) {
            double[] spread = new double[count];
            for (int i = 0; i < count; i++) {
                spread[i] = seenSpread(i * stride, series.window(), memory);
            }
            // The constant is the first place's own, which the intercept takes.
            walks.add(matrix(count, (i, j) -> 0.5 * (spread[i] + spread[j] - spread[Math.abs(i - j)]) + stride));
        }
    }

    @FunctionalInterface
    private interface Entry {
        double at(int row, int column);
    }

    private static RealMatrix matrix(int size, Entry entry) {
        double[][] values = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                values[i][j] = entry.at(i, j);
            }
        }
        return new Array2DRowRealMatrix(values, false);
    }

    /** Correlation of white noise under two Hann windows that lie some of their lengths apart. */
    private static double overlap(double windows) {
        double x = Math.abs(windows);
        if (x >= 1) {
            return 0;
        }
        // Integral of cos^2(pi y) cos^2(pi (y - x)) over the common part, over its value at 0, 3 / 8.
        return ((1 - x) * (2 + Math.cos(2 * Math.PI * x)) + 3 / (2 * Math.PI) * Math.sin(2 * Math.PI * x)) / 3;
    }

    /**
     * Variance of the walk's difference between two places, as seen through windows: one per place where these are far
     * apart.
     *
     * @param distance of the places
     * @param window their length, in places
     * @param memory over how many places the walk keeps its pace
     */
    private static double seenSpread(double distance, double window, double memory) {
        DoubleUnaryOperator spread = places -> {
            double apart = Math.abs(places);
            return memory == 0 ? apart : apart - memory * -Math.expm1(-apart / memory);
        };
        double sum = 0;
        double weights = 0;
        for (int i = -NODES; i <= NODES; i++) {
            double weight = overlap((double) i / NODES);
            double shift = window * i / NODES;
            sum += weight * (spread.applyAsDouble(distance - shift) - spread.applyAsDouble(shift));
            weights += weight;
        }
        return sum / weights;
    }

    /** A place without any wave still has some weight, or its phase would be any. */
    private static double relative(double strength, double mean) {
        return mean > 0 ? Math.max(0.05, strength / mean) : 1;
    }

    /** Radians per place. */
    Interval slope(double probability) {
        return mixed(answers(2, 1), probability);
    }

    /** How likely it is, 0..1, that gaps deviate, so that the phase wanders; and not lines from their places. */
    double wandering() {
        double[] weights = weights(answers(2, 1));
        double sum = 0;
        for (int i = 1; i < weights.length; i++) {
            sum += ratio((i - 1) % RATIOS) >= WANDERING_RATIO ? weights[i] : 0;
        }
        return sum;
    }

    private static double ratio(int i) {
        return SMALLEST_RATIO * Math.pow(LARGEST_RATIO / SMALLEST_RATIO, i / (RATIOS - 1.0));
    }

    /** Radians per place squared: half the slope's change from one place to the next. */
    Interval curvature(double probability) {
        return mixed(answers(3, 2), probability);
    }

    /** The slope where a curvature is taken into account, in the middle; radians per place. */
    Interval slopeInTheMiddle(double probability) {
        return mixed(answers(3, 1), probability);
    }

    /** Under all ratios, for a line (2 terms) or a parabola (3). */
    private List<Answer> answers(int terms, int wanted) {
        List<Answer> answers = new ArrayList<>();
        answers.add(answer(white, Math.log(MEMORIES.length), terms, wanted));
        for (RealMatrix walk : walks) {
            for (int i = 0; i < RATIOS; i++) {
                double ratio = ratio(i);
                RealMatrix covariance = white.add(walk.scalarMultiply(ratio)).scalarMultiply(1 / (1 + ratio));
                answers.add(answer(covariance, 0, terms, wanted));
            }
        }
        return answers;
    }

    private Answer answer(RealMatrix covariance, double logPrior, int terms, int wanted) {
        int count = places.length;
        RealMatrix design = new Array2DRowRealMatrix(count, terms);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < terms; k++) {
                design.setEntry(i, k, Math.pow(places[i], k));
            }
        }
        RealMatrix values = new Array2DRowRealMatrix(phases);
        CholeskyDecomposition cholesky = cholesky(covariance);
        DecompositionSolver inverse = cholesky.getSolver();
        RealMatrix weighted = inverse.solve(design).transpose();
        LUDecomposition normal = new LUDecomposition(weighted.multiply(design));
        RealMatrix coefficients = normal.getSolver().solve(weighted.multiply(values));
        RealMatrix rest = values.subtract(design.multiply(coefficients));
        double squares = rest.transpose().multiply(inverse.solve(rest)).getEntry(0, 0);
        int freedom = count - terms;
        // 1e-20: a phase that is followed to 1e-10 radians is exact.
        double variance = Math.max(1e-20, squares / freedom);
        double error = Math.sqrt(variance * normal.getSolver().getInverse().getEntry(wanted, wanted));
        double likelihood = logPrior
                - 0.5
                        * (logDeterminant(cholesky)
                                + Math.log(Math.abs(normal.getDeterminant()))
                                + freedom * Math.log(variance));
        return new Answer(likelihood, coefficients.getEntry(wanted, 0), error, freedom);
    }

    private static CholeskyDecomposition cholesky(RealMatrix covariance) {
        try {
            return new CholeskyDecomposition(covariance, 1e-10, 1e-14);
        } catch (NonPositiveDefiniteMatrixException rounding) {
            RealMatrix stiffer = covariance.copy();
            for (int i = 0; i < stiffer.getRowDimension(); i++) {
                stiffer.addToEntry(i, i, 1e-3 * covariance.getEntry(i, i));
            }
            return new CholeskyDecomposition(stiffer, 1e-10, 1e-14);
        }
    }

    private static double logDeterminant(CholeskyDecomposition cholesky) {
        RealMatrix lower = cholesky.getL();
        double sum = 0;
        for (int i = 0; i < lower.getRowDimension(); i++) {
            sum += 2 * Math.log(lower.getEntry(i, i));
        }
        return sum;
    }

    /** Quantiles of the mixture of all answers' Student distributions, by bisection. */
    private static Interval mixed(List<Answer> answers, double probability) {
        double[] weights = weights(answers);
        return new Interval(
                quantile(answers, weights, 0.5 - 0.5 * probability),
                quantile(answers, weights, 0.5),
                quantile(answers, weights, 0.5 + 0.5 * probability));
    }

    /** Shares of the answers; all together 1. */
    private static double[] weights(List<Answer> answers) {
        double largest = answers.stream().mapToDouble(Answer::logWeight).max().orElseThrow();
        double[] weights = answers.stream()
                .mapToDouble(answer -> Math.exp(answer.logWeight() - largest))
                .toArray();
        double sum = 0;
        for (double weight : weights) {
            sum += weight;
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] /= sum;
        }
        return weights;
    }

    private static double quantile(List<Answer> answers, double[] weights, double share) {
        TDistribution student = new TDistribution(null, answers.get(0).freedom());
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (Answer answer : answers) {
            low = Math.min(low, answer.value() - 100 * answer.error());
            high = Math.max(high, answer.value() + 100 * answer.error());
        }
        for (int i = 0; i < 80; i++) {
            double middle = 0.5 * (low + high);
            double below = 0;
            for (int k = 0; k < weights.length; k++) {
                Answer answer = answers.get(k);
                below += weights[k] * student.cumulativeProbability((middle - answer.value()) / answer.error());
            }
            if (below < share) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return 0.5 * (low + high);
    }
}
