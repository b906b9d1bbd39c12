package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.Optional;

/**
 * Whether one wave or two make a series of complex amplitudes at equal steps: least squares of A exp(i a k) + B exp(i b k)
 * over all pairs of turns a, b within half a turn.
 *
 * @param first radians per place, of the stronger wave
 * @param second radians per place
 * @param ratio of their amplitudes, 0..1
 * @param rest share of the series' power that two waves leave unexplained, 0..1
 */
record TwoWaves(double first, double second, double ratio, double rest) {
    // Of the power that one wave leaves, what two must not leave: noise and disorder are not so neat.
    private static final double LARGEST_REST = 0.03;
    private static final double WEAKEST = 0.2;
    // In turns over the whole series. Closer waves are one whose amplitude grows or falls across the scan.
    private static final double CLOSEST = 0.75;
    private static final int REFINEMENTS = 40;
    private static final int MOST = 200;

    /** Two waves where they explain what one does not. */
    static Optional<TwoWaves> in(double[][] all) {
        int count = Math.min(MOST, all.length);
        int start = (all.length - count) / 2;
        double[][] series = Arrays.copyOfRange(all, start, start + count);
        double power = 0;
        for (double[] value : series) {
            power += value[0] * value[0] + value[1] * value[1];
        }
        if (count < 6 || !(power > 0)) {
            return Optional.empty();
        }
        double step = Math.PI / (2 * count);
        int reach = (int) Math.ceil(0.9 * Math.PI / step);
        double[][] spectrum = new double[2 * reach + 1][];
        for (int i = -reach; i <= reach; i++) {
            spectrum[i + reach] = correlation(series, i * step);
        }
        double best = -1;
        double one = 0;
        double a = 0;
        double b = 0;
        for (int i = -reach; i <= reach; i++) {
            one = Math.max(one, square(spectrum[i + reach]) / count);
            // Closer waves are one that fades.
            for (int j = i + 4; j <= reach; j++) {
                double explained = explained(spectrum[i + reach], spectrum[j + reach], (j - i) * step, count);
                if (explained > best) {
                    best = explained;
                    a = i * step;
                    b = j * step;
                }
            }
        }
        for (int i = 0; i < REFINEMENTS; i++) {
            step *= 0.8;
            for (int move = 0; move < 4; move++) {
                double triedA = a + (move == 0 ? step : move == 1 ? -step : 0);
                double triedB = b + (move == 2 ? step : move == 3 ? -step : 0);
                double explained =
                        explained(correlation(series, triedA), correlation(series, triedB), triedB - triedA, count);
                if (explained > best) {
                    best = explained;
                    a = triedA;
                    b = triedB;
                }
            }
        }
        return judged(series, power, one, best, a, b);
    }

    private static Optional<TwoWaves> judged(
            double[][] series, double power, double one, double best, double a, double b) {
        double rest = 1 - best / power;
        double[] amplitudes = amplitudes(correlation(series, a), correlation(series, b), b - a, series.length);
        boolean firstIsStronger = amplitudes[0] >= amplitudes[1];
        double ratio = firstIsStronger ? amplitudes[1] / amplitudes[0] : amplitudes[0] / amplitudes[1];
        double restOfOne = 1 - one / power;
        boolean apart = Math.abs(b - a) * series.length >= 2 * Math.PI * CLOSEST;
        boolean two = apart && rest <= LARGEST_REST && rest <= 0.25 * restOfOne && ratio >= WEAKEST;
        return two
                ? Optional.of(new TwoWaves(firstIsStronger ? a : b, firstIsStronger ? b : a, ratio, rest))
                : Optional.empty();
    }

    /** sum c exp(-i a k), places counted from the middle. */
    private static double[] correlation(double[][] series, double turn) {
        double[] sum = new double[2];
        for (int k = 0; k < series.length; k++) {
            double angle = -turn * (k - 0.5 * (series.length - 1));
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            sum[0] += series[k][0] * cosine - series[k][1] * sine;
            sum[1] += series[k][0] * sine + series[k][1] * cosine;
        }
        return sum;
    }

    /** Dirichlet kernel: the scalar product of two unit waves, real for places counted from the middle. */
    private static double product(double difference, int count) {
        double half = 0.5 * difference;
        return Math.abs(Math.sin(half)) < 1e-9 ? count : Math.sin(count * half) / Math.sin(half);
    }

    private static double explained(double[] x, double[] y, double difference, int count) {
        double d = product(difference, count);
        double determinant = (double) count * count - d * d;
        if (determinant < 1e-6 * count * count) {
            return -1;
        }
        return (count * (square(x) + square(y)) - 2 * d * (x[0] * y[0] + x[1] * y[1])) / determinant;
    }

    private static double[] amplitudes(double[] x, double[] y, double difference, int count) {
        double d = product(difference, count);
        double determinant = (double) count * count - d * d;
        double[] a = {(count * x[0] - d * y[0]) / determinant, (count * x[1] - d * y[1]) / determinant};
        double[] b = {(count * y[0] - d * x[0]) / determinant, (count * y[1] - d * x[1]) / determinant};
        return new double[] {Math.sqrt(square(a)), Math.sqrt(square(b))};
    }

    private static double square(double[] value) {
        return value[0] * value[0] + value[1] * value[1];
    }
}
