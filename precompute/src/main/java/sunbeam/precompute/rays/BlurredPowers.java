package sunbeam.precompute.rays;

import java.util.Arrays;
import sunbeam.precompute.optics.CoherenceWindow;

/**
 * The terms of a surface's powers, at any frequency, under a window: sums of Gaussians around the DFT bins (design, section
 * 3), in double precision. Bins as far apart as the Gaussians are wide are summed one by one; bins that lie closer have been blurred where
 * they lie, once, and are interpolated by quintic B-splines, of which six times six meet. Immutable.
 */
final class BlurredPowers {
    // Distance of bins in sigma_f, up to which B-splines err by no more than 6e-4 of a bin beside it, and far from it
    // by nothing.
    private static final double INTERPOLATED_SPACING = 0.5;
    // Beyond its reach a Gaussian's B-splines go on, and cancel each other; so many bins farther they count nothing.
    private static final int SPLINE_MARGIN = 6;

    private final BinPlane bins;
    private final double sigmaFrequency;
    private final double reach;
    private final boolean isBlurred;

    private BlurredPowers(BinPlane bins, CoherenceWindow window, double reach, boolean isBlurred) {
        this.bins = bins;
        this.sigmaFrequency = window.sigmaFrequency();
        this.reach = reach;
        this.isBlurred = isBlurred;
    }

    /**
     * Powers under a window.
     *
     * @param reach in the window's sigma_f, beyond which a bin is left out: exp(-reach^2) of it
     * @param interpolated whether to interpolate where bins lie close beside the window's width
     */
    static BlurredPowers of(BinPlane bins, CoherenceWindow window, double reach, boolean interpolated) {
        double spacingX = 1 / (window.sigmaFrequency() * bins.periodX());
        double spacingY = 1 / (window.sigmaFrequency() * bins.periodY());
        if (!interpolated || Math.max(spacingX, spacingY) > INTERPOLATED_SPACING) {
            return new BlurredPowers(bins, window, reach, false);
        }
        BinPlane blurred = bins.convolved(splines(spacingX, reach), splines(spacingY, reach));
        return new BlurredPowers(blurred, window, reach, true);
    }

    /** Coefficients of the B-splines, one a bin, that add up to a Gaussian around the middle one of them. */
    private static double[] splines(double spacing, double reach) {
        int side = (int) Math.ceil(reach / spacing) + SPLINE_MARGIN;
        float[] values = new float[2 * side + 1];
        for (int i = 0; i < values.length; i++) {
            double distance = (i - side) * spacing;
            values[i] = (float) Math.exp(-distance * distance);
        }
        QuinticSpline.alongRows(values, 1, values.length);
        double[] coefficients = new double[values.length];
        Arrays.setAll(coefficients, i -> values[i]);
        return coefficients;
    }

    int terms() {
        return bins.terms();
    }

    /**
     * All terms at frequencies on a ray from the origin.
     *
     * @param cosine of the ray's angle
     * @param sine of the ray's angle
     * @param frequencies cycles per metre
     * @param terms where they are put, {@code [term][frequency]}
     */
    void alongRay(double cosine, double sine, double[] frequencies, double[][] terms) {
        Axis x = new Axis(bins.periodX(), bins.firstX(), bins.columns());
        Axis y = new Axis(bins.periodY(), bins.firstY(), bins.rows());
        double[] sums = new double[bins.stride()];
        for (int i = 0; i < frequencies.length; i++) {
            x.moveTo(cosine * frequencies[i]);
            y.moveTo(sine * frequencies[i]);
            sum(x, y, sums);
            for (int m = 0; m < terms.length; m++) {
                terms[m][i] = sums[m];
            }
        }
    }

    /** Four terms at a time: their sums stay in registers. */
    private void sum(Axis x, Axis y, double[] sums) {
        int count = bins.stride();
        double[] powers = bins.powers();
        for (int m = 0; m < count; m += BinPlane.TOGETHER) {
            double sum0 = 0;
            double sum1 = 0;
            double sum2 = 0;
            double sum3 = 0;
            for (int j = 0; j < y.count; j++) {
                int at = ((y.from + j) * bins.columns() + x.from) * count + m;
                double weightY = y.weights[j];
                for (int i = 0; i < x.count; i++) {
                    double weight = weightY * x.weights[i];
                    sum0 += weight * powers[at];
                    sum1 += weight * powers[at + 1];
                    sum2 += weight * powers[at + 2];
                    sum3 += weight * powers[at + 3];
                    at += count;
                }
            }
            sums[m] = sum0;
            sums[m + 1] = sum1;
            sums[m + 2] = sum2;
            sums[m + 3] = sum3;
        }
    }

    /** The bins along one axis that lend to a frequency, and how much. */
    private final class Axis {
        private final double period;
        private final int first;
        private final int bins;
        private final double ratio;
        private final double change;
        private final double[] weights;
        private int from;
        private int count;

        Axis(double period, int first, int bins) {
            this.period = period;
            this.first = first;
            this.bins = bins;
            this.ratio = 1 / (sigmaFrequency * period);
            this.change = Math.exp(-2 * ratio * ratio);
            this.weights = new double[Math.max(QuinticSpline.TAPS, 3 + (int) Math.ceil(2 * reach / ratio))];
        }

        void moveTo(double frequency) {
            double bin = frequency * period - first;
            if (isBlurred) {
                moveAmongSplines(bin);
            } else {
                moveAmongGaussians(bin);
            }
        }

        private void moveAmongSplines(double bin) {
            int below = (int) Math.floor(bin);
            int begin = below - QuinticSpline.TAPS / 2 + 1;
            QuinticSpline.weights(bin - below, weights);
            from = Math.max(0, Math.min(begin, bins));
            count = Math.max(0, Math.min(bins, begin + QuinticSpline.TAPS) - from);
            if (from > begin) {
                System.arraycopy(weights, Math.min(from - begin, QuinticSpline.TAPS), weights, 0, count);
            }
        }

        private void moveAmongGaussians(double bin) {
            from = (int) Math.max(0, Math.ceil(bin - reach / ratio));
            int last = (int) Math.min(bins - 1.0, Math.floor(bin + reach / ratio));
            count = Math.max(0, last - from + 1);
            // exp(-(x + i r)^2) = exp(-x^2) exp(-2 x r)^i exp(-r^2)^(i^2): two exponentials in place of one a bin.
            double x = (from - bin) * ratio;
            double weight = Math.exp(-x * x);
            double factor = Math.exp(-(2 * x + ratio) * ratio);
            for (int i = 0; i < count; i++) {
                weights[i] = weight;
                weight *= factor;
                factor *= change;
            }
        }
    }
}
