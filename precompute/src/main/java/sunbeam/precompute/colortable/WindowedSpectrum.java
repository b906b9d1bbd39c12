package sunbeam.precompute.colortable;

import java.util.Arrays;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.spectrum.PowerSpectrum;

/**
 * {@link PowerSpectrum} under a window: at any frequency, the sum of the bins' terms times Gaussians of their distance. Bins beyond
 * {@code reach} sigma_f, of weights below exp(-reach^2), are left out. Immutable.
 */
record WindowedSpectrum(PowerSpectrum bins, double sigmaFrequency, double reach) {
    /** Largest spacing of decimated bins, in sigma_f: polynomials of degree 7 between them err by 1e-3. */
    private static final double DECIMATED_SPACING = 0.4;

    /** The window is no longer than the plan's; decimation merges bins closer than 0.4 sigma_f, with an error of 1e-3. */
    static WindowedSpectrum of(PowerSpectrum spectrum, CoherenceWindow window, double reach, boolean decimated) {
        double sigmaFrequency = window.sigmaFrequency();
        double spacing = decimated ? DECIMATED_SPACING * sigmaFrequency : 0;
        return new WindowedSpectrum(spectrum.decimated(spacing), sigmaFrequency, reach);
    }

    private GaussianWeights weights(PowerSpectrum.Axis axis) {
        return new GaussianWeights(axis, sigmaFrequency, reach);
    }

    /** Gaussian weights exp(-(distance / sigma_f)^2) of the DFT bins within reach of a frequency, along one axis. Not thread-safe. */
    static final class GaussianWeights {
        private final double ratio;
        private final double reach;
        private final double factorStep;
        /** The first {@link #count} are valid: they belong to the bins from {@link #first} on. */
        final double[] weights;

        int first;
        int count;

        GaussianWeights(PowerSpectrum.Axis bins, double sigmaFrequency, double reach) {
            // Distance between neighboring bins, divided by sigma_f.
            this.ratio = 1 / (sigmaFrequency * bins.period());
            this.reach = reach;
            this.factorStep = Math.exp(-2 * ratio * ratio);
            this.weights = new double[3 + (int) Math.ceil(2 * reach / ratio)];
        }

        /** Computes the weights around a position in bins, of which those from lowest to highest exist. */
        void moveTo(double place, int lowest, int highest) {
            first = (int) Math.max(lowest, Math.ceil(place - reach / ratio));
            int last = (int) Math.min(highest, Math.floor(place + reach / ratio));
            count = Math.max(0, last - first + 1);
            // exp(-(x + i r)^2) = exp(-x^2) exp(-2 x r)^i exp(-r^2)^(i^2): two exponentials instead of one per bin.
            double distance = (first - place) * ratio;
            double weight = CoherenceWindow.power(distance);
            double factor = Math.exp(-(2 * distance + ratio) * ratio);
            for (int i = 0; i < count; i++) {
                weights[i] = weight;
                weight *= factor;
                factor *= factorStep;
            }
        }
    }

    /** Not thread-safe. */
    final class Sums {
        private final GaussianWeights x = weights(bins.x());
        private final GaussianWeights y = weights(bins.y());
        private final double[] sums = new double[bins.stride()];

        /** Returns all terms at a frequency in cycles per meter; overwritten by the next call. */
        double[] at(double fx, double fy) {
            x.moveTo(bins.x().place(fx), 0, bins.x().count() - 1);
            y.moveTo(bins.y().place(fy), 0, bins.y().count() - 1);
            Arrays.fill(sums, 0);
            double[] powers = bins.powers();
            for (int j = 0; j < y.count; j++) {
                int at = ((y.first + j) * bins.x().count() + x.first) * sums.length;
                for (int i = 0; i < x.count; i++, at += sums.length) {
                    double weight = y.weights[j] * x.weights[i];
                    for (int m = 0; m < sums.length; m++) {
                        sums[m] += weight * powers[at + m];
                    }
                }
            }
            return sums;
        }
    }

    static boolean isAlongX(double angle) {
        return Math.abs(Math.cos(angle)) >= Math.abs(Math.sin(angle));
    }

    /** Knots of cubic B-splines along a ray, equally spaced in ln |f|, f in cycles per meter. */
    record Knots(double first, double spacing, int count) {
        private static final int REACH = 2;

        /** Returns the lowest |f| in the support of any spline, in cycles per meter. */
        double lowest() {
            return Math.exp(first - REACH * spacing);
        }

        double highest() {
            return Math.exp(first + (count - 1 + REACH) * spacing);
        }
    }

    /**
     * Batch of rays close to each other, which share one blurred spectrum. A line holds the frequencies that have the same component along
     * the axis nearest to the rays; there the terms are blurred along this axis once, so that where a ray crosses a line only the bins along
     * it are left to sum. Cubic B-splines of ln |f| average these points by the trapezoid rule, in a coordinate in which lines are equally
     * spaced; at a spacing of 0.75 sigma_f it errs by 2 exp(-(pi / 0.75)^2) = 5e-8 for Gaussians. Not thread-safe.
     */
    final class RayBatch {
        // Largest spacing of lines along a ray, in knot spacings and in sigma_f.
        private static final double MOST_KNOT_SPACINGS = 1.1;
        private static final double MOST_SIGMAS = 0.75;
        private static final double RELATIVE_TOLERANCE = 1e-12;
        private static final int SHARES = 4;

        private final boolean alongX;
        // Transposed if necessary, so that the rays cross rows.
        private final PowerSpectrum crossed;
        private final Knots knots;
        private final GaussianWeights weights;
        private final Line[] lines;
        private final double[] blurred;

        /** Line at a frequency along the axis, with its weight in ln |f| and its range of blurred bins, from {@code offset} on. */
        private record Line(double frequency, double logarithm, double weight, int firstBin, int count, int offset) {}

        /** Blurs the spectrum between two angles to the x axis, radians, less than 90 degrees apart and closer to the same axis. */
        RayBatch(double firstAngle, double lastAngle, Knots knots) {
            this.alongX = isAlongX(0.5 * (firstAngle + lastAngle));
            this.crossed = alongX ? bins.transposed() : bins;
            this.knots = knots;
            this.weights = weights(crossed.x());
            double firstAlong = Math.abs(along(firstAngle));
            double lastAlong = Math.abs(along(lastAngle));
            double least = Math.min(firstAlong, lastAlong);
            boolean isAroundAxis = across(firstAngle) * across(lastAngle) <= 0;
            double most = isAroundAxis ? 1 : Math.max(firstAlong, lastAlong);
            double byLogarithm = MOST_KNOT_SPACINGS * knots.spacing;
            double byFrequency = MOST_SIGMAS * sigmaFrequency * least;
            double[] frequencies =
                    frequencies(byLogarithm, byFrequency, least * knots.lowest(), most * knots.highest());
            double[] slopes = {across(firstAngle) / firstAlong, across(lastAngle) / lastAlong};
            Arrays.sort(slopes);
            double margin = reach * sigmaFrequency;
            PowerSpectrum.Axis x = crossed.x();
            this.lines = new Line[frequencies.length];
            int size = 0;
            for (int i = 0; i < lines.length; i++) {
                double f = frequencies[i];
                int firstBin = (int) Math.max(0, Math.ceil(x.place(f * slopes[0] - margin)));
                double lastBin = Math.min(x.count() - 1.0, Math.floor(x.place(f * slopes[1] + margin)));
                int count = Math.max(0, (int) lastBin - firstBin + 1);
                lines[i] = new Line(f, Math.log(f), 1 / (1 / byLogarithm + f / byFrequency), firstBin, count, size);
                size = Math.addExact(size, count * crossed.stride());
            }
            this.blurred = new double[size];
            GaussianWeights rows = weights(crossed.y());
            double sign = Math.signum(along(firstAngle));
            for (Line line : lines) {
                rows.moveTo(
                        crossed.y().place(sign * line.frequency), 0, crossed.y().count() - 1);
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
                // Newton's method from the line before; the function is concave, so that it overshoots at most once.
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
            double[] powers = crossed.powers();
            double[] to = blurred;
            int begin = line.offset;
            int length = line.count * crossed.stride();
            int perRow = crossed.x().count() * crossed.stride();
            int from = rows.first * perRow + line.firstBin * crossed.stride();
            int row = 0;
            for (; row + 3 < rows.count; row += 4, from += 4 * perRow) {
                double weight0 = rows.weights[row];
                double weight1 = rows.weights[row + 1];
                double weight2 = rows.weights[row + 2];
                double weight3 = rows.weights[row + 3];
                int at1 = from + perRow;
                int at2 = at1 + perRow;
                int at3 = at2 + perRow;
                for (int i = 0; i < length; i++) {
                    to[begin + i] += weight0 * powers[from + i]
                            + weight1 * powers[at1 + i]
                            + weight2 * powers[at2 + i]
                            + weight3 * powers[at3 + i];
                }
            }
            for (; row < rows.count; row++, from += perRow) {
                double weight = rows.weights[row];
                for (int i = 0; i < length; i++) {
                    to[begin + i] += weight * powers[from + i];
                }
            }
        }

        /** Computes {@code [knot][term]}, padded to the bins' stride, along a ray at this angle to the x axis, radians. */
        void averages(double angle, double[] averages) {
            Arrays.fill(averages, 0);
            double along = Math.abs(along(angle));
            double slope = across(angle) / along;
            double toKnots = 1 / knots.spacing;
            double first = knots.first + Math.log(along);
            double[] shares = new double[SHARES];
            for (Line line : lines) {
                double place = (line.logarithm - first) * toKnots + SHARES;
                int below = (int) place;
                int knot = below - SHARES - 1;
                if (place < 0 || knot <= -SHARES || knot >= knots.count) {
                    continue;
                }
                shares(place - below, line.weight * toKnots, shares);
                double bin = crossed.x().place(line.frequency * slope);
                weights.moveTo(bin, line.firstBin, line.firstBin + line.count - 1);
                if (weights.count > 0) {
                    add(line, knot, shares, averages);
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
        private void add(Line line, int knot, double[] shares, double[] averages) {
            int stride = crossed.stride();
            double[] values = blurred;
            double[] binWeights = weights.weights;
            int count = weights.count;
            int first = line.offset + (weights.first - line.firstBin) * stride;
            int end = Math.min(SHARES, knots.count - knot);
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
                for (int k = Math.max(0, -knot); k < end; k++) {
                    int to = (knot + k) * stride + m;
                    averages[to] += shares[k] * sum0;
                    averages[to + 1] += shares[k] * sum1;
                    averages[to + 2] += shares[k] * sum2;
                    averages[to + 3] += shares[k] * sum3;
                }
            }
        }
    }
}
