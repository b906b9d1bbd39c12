package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.List;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.TreeSet;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.interpolation.SplineInterpolator;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Tabulated relative power of a light, at least 0, by wavelength in nanometers from 380 or below to 780 or above, and its values at each
 * nanometer (CIE 167:2005). Equal steps are interpolated by Sprague's polynomials of degree 5, others by a natural cubic spline. Rows too far
 * apart for the spectrum, as of lamps with lines, are joined by lines. Tables with rows closer than a nanometer are averaged with a triangle of 1 nm
 * full width at half maximum, so that no line is lost. The map must not change afterwards.
 */
record SpectralRows(NavigableMap<Double, Double> power) {
    // Rows on each side that predict the row between them.
    private static final int NEIGHBORS = 3;
    // Largest error of that prediction, relative to the strongest power. A Gaussian peak at this limit has a deviation
    // of
    // 0.95 steps: Sprague's polynomials err by 4 % of it, lines by 13 %.
    private static final double LARGEST_SURPRISE = 0.2;
    // Relative difference of steps that count as equal.
    private static final double EQUAL = 1e-6;

    /** Returns the power at each nanometer from 380 to 780 nm. */
    double[] perNanometer() {
        DoubleUnaryOperator function = function();
        return IntStream.rangeClosed(0, Illuminant.LAST)
                .mapToDouble(i -> function.applyAsDouble(CieTable.FIRST_NANOMETER + i))
                .toArray();
    }

    private DoubleUnaryOperator function() {
        double[] rows = power.keySet().stream().mapToDouble(Double::doubleValue).toArray();
        double[] steps = IntStream.range(1, rows.length)
                .mapToDouble(i -> rows[i] - rows[i - 1])
                .toArray();
        double shortest = Arrays.stream(steps).min().orElse(0);
        double longest = Arrays.stream(steps).max().orElse(0);
        if (shortest < 1) {
            return this::average;
        }
        if (!isResolved(rows)) {
            return nanometers -> Lagrange.between(power, nanometers);
        }
        DoubleUnaryOperator smooth = longest - shortest <= EQUAL * longest ? sprague(rows[0], longest) : spline(rows);
        // Polynomials swing around zero beside steep flanks, but no power is negative, and none is between dark rows.
        return nanometers -> isDark(nanometers) ? 0 : Math.max(0, smooth.applyAsDouble(nanometers));
    }

    private boolean isDark(double nanometers) {
        return power.floorEntry(nanometers).getValue() == 0
                && power.ceilingEntry(nanometers).getValue() == 0;
    }

    private double[] values() {
        return power.values().stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** Returns whether the polynomial through its neighbors predicts each row but the outermost. */
    private boolean isResolved(double[] rows) {
        double[] values = values();
        double allowed = LARGEST_SURPRISE * Arrays.stream(values).max().orElse(0);
        return rows.length > 2 * NEIGHBORS
                && IntStream.range(NEIGHBORS, rows.length - NEIGHBORS)
                        .allMatch(row -> Math.abs(predicted(rows, values, row) - values[row]) <= allowed);
    }

    private static double predicted(double[] rows, double[] values, int row) {
        double sum = 0;
        for (int tap = row - NEIGHBORS; tap <= row + NEIGHBORS; tap++) {
            double weight = tap == row ? 0 : 1;
            for (int other = row - NEIGHBORS; other <= row + NEIGHBORS; other++) {
                weight *= other == tap || other == row ? 1 : (rows[row] - rows[other]) / (rows[tap] - rows[other]);
            }
            sum += weight * values[tap];
        }
        return sum;
    }

    private DoubleUnaryOperator spline(double[] rows) {
        return new SplineInterpolator().interpolate(rows, values())::value;
    }

    private DoubleUnaryOperator sprague(double first, double step) {
        double[] padded = Sprague.padded(values());
        return nanometers -> Sprague.at(padded, (nanometers - first) / step);
    }

    /** Simpson's rule is exact for products of two linear functions. */
    private double average(double middle) {
        double from = Math.max(middle - 1, power.firstKey());
        double to = Math.min(middle + 1, power.lastKey());
        NavigableSet<Double> ends =
                new TreeSet<>(power.subMap(from, true, to, true).keySet());
        ends.addAll(List.of(from, middle, to));
        double sum = 0;
        double weight = 0;
        for (double end : ends.tailSet(from, false)) {
            double start = ends.lower(end);
            for (double at : List.of(start, 0.5 * (start + end), end)) {
                double share = (end - start) * (1 - Math.abs(at - middle)) * (at == start || at == end ? 1 : 4);
                sum += share * Lagrange.between(power, at);
                weight += share;
            }
        }
        return sum / weight;
    }

    /** Interpolation of equal steps by polynomials of degree 5 with continuous second derivatives (T. Sprague 1880; CIE 167:2005). */
    private static final class Sprague {
        // Weights of the first six rows, times 209, in the two rows that the method adds before them, and mirrored
        // behind the last.
        private static final double[][] BEFORE = {
            {884, -1960, 3033, -2648, 1080, -180}, {508, -540, 488, -367, 144, -24}
        };
        private static final double SCALE = 209;
        // Coefficients of t^0 to t^5 by rows -2 to 3 around the interval, times 24.
        private static final double[][] COEFFICIENTS = {
            {0, 0, 24, 0, 0, 0},
            {2, -16, 0, 16, -2, 0},
            {-1, 16, -30, 16, -1, 0},
            {-9, 39, -70, 66, -33, 7},
            {13, -64, 126, -124, 61, -12},
            {-5, 25, -50, 50, -25, 5}
        };

        /** Returns the values with two more at either end. */
        static double[] padded(double[] values) {
            int last = values.length - 1;
            double[] padded = new double[values.length + 4];
            System.arraycopy(values, 0, padded, 2, values.length);
            for (int end = 0; end < 2; end++) {
                for (int i = 0; i < 6; i++) {
                    padded[end] += BEFORE[end][i] / SCALE * values[i];
                    padded[last + 4 - end] += BEFORE[end][i] / SCALE * values[last - i];
                }
            }
            return padded;
        }

        /** Returns the value at a place in steps from the first row. */
        static double at(double[] padded, double place) {
            int interval = (int) Math.max(0, Math.min(padded.length - 6.0, Math.floor(place)));
            double t = place - interval;
            double sum = 0;
            for (int power = 5; power >= 0; power--) {
                double coefficient = 0;
                for (int tap = 0; tap < 6; tap++) {
                    coefficient += COEFFICIENTS[power][tap] / 24 * padded[interval + tap];
                }
                sum = sum * t + coefficient;
            }
            return sum;
        }
    }
}
