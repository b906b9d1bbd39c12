package sunbeam.precompute.colortable;

import java.util.Arrays;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.spectrum.PowerSpectrum.GaussianWeights;

/**
 * Batch of rays close to each other, which share one blurred spectrum. A line holds the frequencies that have the same component along the
 * axis nearest to the rays; there the terms are blurred along this axis once, so that where a ray crosses a line only the bins along it are
 * left to sum. Cubic B-splines of ln |f| average these points by the trapezoid rule, in a coordinate in which lines are equally spaced; at
 * a spacing of 0.75 sigma_f it errs by 2 exp(-(pi / 0.75)^2) = 5e-8 for Gaussians. Not thread-safe.
 */
final class RayBatch {
    // Largest spacing of lines along a ray, in knot spacings and in sigma_f.
    private static final double MOST_KNOT_SPACINGS = 1.1;
    private static final double MOST_SIGMAS = 0.75;
    private static final double RELATIVE_TOLERANCE = 1e-12;
    private static final int SHARES = 4;

    private final PowerSpectrum bins;
    private final boolean alongX;
    private final Knots knots;
    private final GaussianWeights weights;
    private final Line[] lines;
    private final double[] blurred;

    /** Line at a frequency along the axis, with its weight in ln |f| and its range of blurred bins, from {@code offset} on. */
    private record Line(double frequency, double logarithm, double weight, int firstBin, int count, int offset) {}

    /** Knots of cubic B-splines along a ray, equally spaced in ln |f|, f in cycles per meter. */
    record Knots(double first, double spacing, int count) {
        static final int REACH = 2;

        /** Returns the lowest |f| in the support of any spline, in cycles per meter. */
        double lowest() {
            return Math.exp(first - REACH * spacing);
        }

        double highest() {
            return Math.exp(first + (count - 1 + REACH) * spacing);
        }
    }

    /**
     * Creates a batch between two angles to the x axis, radians. The bins are transposed if necessary so that the rays cross rows,
     * {@code alongX} if all bins of a row have the same x; those beyond {@code reach} sigma_f are left out.
     */
    RayBatch(
            PowerSpectrum bins,
            boolean alongX,
            double sigmaFrequency,
            double reach,
            double firstAngle,
            double lastAngle,
            Knots knots) {
        this.bins = bins;
        this.alongX = alongX;
        this.knots = knots;
        this.weights = new GaussianWeights(bins.x(), sigmaFrequency, reach);
        double firstAlong = Math.abs(along(firstAngle));
        double lastAlong = Math.abs(along(lastAngle));
        double least = Math.min(firstAlong, lastAlong);
        boolean isAroundAxis = across(firstAngle) * across(lastAngle) <= 0;
        double most = isAroundAxis ? 1 : Math.max(firstAlong, lastAlong);
        double byLogarithm = MOST_KNOT_SPACINGS * knots.spacing();
        double byFrequency = MOST_SIGMAS * sigmaFrequency * least;
        double[] frequencies = frequencies(byLogarithm, byFrequency, least * knots.lowest(), most * knots.highest());
        double[] slopes = {across(firstAngle) / firstAlong, across(lastAngle) / lastAlong};
        Arrays.sort(slopes);
        double margin = reach * sigmaFrequency;
        this.lines = new Line[frequencies.length];
        int size = 0;
        for (int i = 0; i < lines.length; i++) {
            double f = frequencies[i];
            int firstBin = (int) Math.max(0, Math.ceil(bins.x().place(f * slopes[0] - margin)));
            double lastBin =
                    Math.min(bins.x().count() - 1.0, Math.floor(bins.x().place(f * slopes[1] + margin)));
            int count = Math.max(0, (int) lastBin - firstBin + 1);
            lines[i] = new Line(f, Math.log(f), 1 / (1 / byLogarithm + f / byFrequency), firstBin, count, size);
            size = Math.addExact(size, count * bins.stride());
        }
        this.blurred = new double[size];
        GaussianWeights rows = new GaussianWeights(bins.y(), sigmaFrequency, reach);
        double sign = Math.signum(along(firstAngle));
        for (Line line : lines) {
            rows.moveTo(bins.y().place(sign * line.frequency), 0, bins.y().count() - 1);
            blur(line, rows);
        }
    }

    /** Returns frequencies f at which ln f / byLogarithm + f / byFrequency grows by 1: steps are at most these two. */
    private static double[] frequencies(double byLogarithm, double byFrequency, double lowest, double highest) {
        double first = Math.log(lowest) / byLogarithm + lowest / byFrequency;
        double last = Math.log(highest) / byLogarithm + highest / byFrequency;
        double[] lines = new double[(int) Math.ceil(last - first) + 1];
        double f = lowest;
        for (int i = 0; i < lines.length; i++) {
            // Newton's method starts from the line before; the function is concave, so that it overshoots at most once.
            double change;
            do {
                double excess = first + i - Math.log(f) / byLogarithm - f / byFrequency;
                change = excess / (1 / (byLogarithm * f) + 1 / byFrequency);
                f += change;
            } while (Math.abs(change) > RELATIVE_TOLERANCE * f);
            lines[i] = f;
        }
        return lines;
    }

    private double along(double angle) {
        return alongX ? Math.cos(angle) : Math.sin(angle);
    }

    private double across(double angle) {
        return alongX ? Math.sin(angle) : Math.cos(angle);
    }

    /** Blurs a line, four rows at a time, which saves memory traffic of the sums. */
    private void blur(Line line, GaussianWeights rows) {
        int stride = bins.stride();
        int length = line.count * stride;
        double[] powers = bins.powers();
        int perRow = bins.x().count() * stride;
        int from = rows.first() * perRow + line.firstBin * stride;
        int row = 0;
        for (; row + 3 < rows.count(); row += 4) {
            addFour(powers, from, perRow, rows.weights(), row, line.offset, length);
            from += 4 * perRow;
        }
        for (; row < rows.count(); row++) {
            addOne(powers, from, rows.weights()[row], line.offset, length);
            from += perRow;
        }
    }

    private void addOne(double[] powers, int from, double weight, int begin, int length) {
        double[] to = blurred;
        int shift = from - begin;
        for (int i = begin; i < begin + length; i++) {
            to[i] += weight * powers[shift + i];
        }
    }

    private void addFour(double[] powers, int from, int perRow, double[] rowWeights, int row, int begin, int length) {
        double[] to = blurred;
        double weight0 = rowWeights[row];
        double weight1 = rowWeights[row + 1];
        double weight2 = rowWeights[row + 2];
        double weight3 = rowWeights[row + 3];
        int at0 = from;
        int at1 = from + perRow;
        int at2 = at1 + perRow;
        int at3 = at2 + perRow;
        for (int i = 0; i < length; i++) {
            to[begin + i] += weight0 * powers[at0 + i]
                    + weight1 * powers[at1 + i]
                    + weight2 * powers[at2 + i]
                    + weight3 * powers[at3 + i];
        }
    }

    /** Computes {@code [knot][term]}, padded to the bins' stride, along a ray at this angle to the x axis, radians. */
    void averages(double angle, double[] averages) {
        Arrays.fill(averages, 0);
        double along = Math.abs(along(angle));
        double slope = across(angle) / along;
        double toKnots = 1 / knots.spacing();
        double first = knots.first() + Math.log(along);
        int last = knots.count() - 1;
        double[] shares = new double[SHARES];
        for (Line line : lines) {
            double place = (line.logarithm - first) * toKnots + SHARES;
            int below = (int) place;
            int knot = below - SHARES - 1;
            if (place < 0 || knot <= -SHARES || knot > last) {
                continue;
            }
            shares(place - below, line.weight * toKnots, shares);
            int begin = Math.max(0, -knot);
            int end = Math.min(SHARES, last + 1 - knot);
            weights.moveTo(bins.x().place(line.frequency * slope), line.firstBin, line.firstBin + line.count - 1);
            if (weights.count() > 0) {
                add(line, knot, shares, begin, end, averages);
            }
        }
    }

    private static void shares(double fraction, double weight, double[] shares) {
        double rest = 1 - fraction;
        double sixth = weight / 6;
        shares[0] = sixth * rest * rest * rest;
        shares[1] = sixth * (4 - 3 * fraction * fraction * (1 + rest));
        shares[2] = sixth * (4 - 3 * rest * rest * (1 + fraction));
        shares[3] = sixth * fraction * fraction * fraction;
    }

    /** Adds the sums along a line to the averages of the knots around, four terms at a time, which stay in registers. */
    private void add(Line line, int knot, double[] shares, int begin, int end, double[] averages) {
        int stride = bins.stride();
        double[] values = blurred;
        double[] binWeights = weights.weights();
        int count = weights.count();
        int first = line.offset + (weights.first() - line.firstBin) * stride;
        for (int m = 0; m < stride; m += PowerSpectrum.TOGETHER) {
            double sum0 = 0;
            double sum1 = 0;
            double sum2 = 0;
            double sum3 = 0;
            int at = first + m;
            for (int i = 0; i < count; i++) {
                double weight = binWeights[i];
                sum0 += weight * values[at];
                sum1 += weight * values[at + 1];
                sum2 += weight * values[at + 2];
                sum3 += weight * values[at + 3];
                at += stride;
            }
            int to = (knot + begin) * stride + m;
            for (int k = begin; k < end; k++) {
                double share = shares[k];
                averages[to] += share * sum0;
                averages[to + 1] += share * sum1;
                averages[to + 2] += share * sum2;
                averages[to + 3] += share * sum3;
                to += stride;
            }
        }
    }
}
