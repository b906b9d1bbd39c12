package sunbeam.precompute.radial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Gaussian pyramid of a power spectrum. Each plane holds the spectrum's terms under one window, sampled on a grid of frequencies and
 * blurred from the plane of the next longer window. Sums over a Gaussian are divided by its area relative to the coherence window's: planes
 * hold means. Immutable.
 */
public final class GaussianPyramid {
    // Ratio of sigma_f from plane to plane: linear interpolation between planes errs by 0.5 % where an order is bright.
    private static final double RATIO = 1.1;
    // Grid spacing in standard deviations of the Gaussian: cubic interpolation errs by 2e-3.
    private static final double SPACING = 0.4;
    // Reach of the blurring Gaussians in their sigma_f: exp(-reach^2) = 1e-6.
    private static final double REACH = 3.7;
    private static final int TAPS = 4;

    private final int stride;
    private final List<Plane> planes = new ArrayList<>();

    /**
     * Plane: powers on a square grid around frequency 0, {@code [row][column][term]}.
     *
     * @param sigmaFrequency sigma_f of the window, cycles per meter
     * @param spacing distance of the grid's nodes, cycles per meter
     * @param half number of nodes on either side of frequency 0, along both axes
     */
    private record Plane(double sigmaFrequency, double spacing, int half, float[] powers) {
        static Plane empty(double sigmaFrequency, double farthest, int stride) {
            double spacing = SPACING * sigmaFrequency / Math.sqrt(2);
            int half = (int) Math.ceil(farthest / spacing) + TAPS / 2;
            int side = 2 * half + 1;
            return new Plane(sigmaFrequency, spacing, half, new float[side * side * stride]);
        }

        int side() {
            return 2 * half + 1;
        }
    }

    /**
     * @param pointSigmaFrequency sigma_f of the coherence window at a point, without slopes; sums under this window are not divided
     * @param narrowest sigma_f of the first plane
     * @param widest sigma_f that the last plane reaches
     * @param farthest largest frequency along either axis, cycles per meter
     */
    GaussianPyramid(SpectrumPlane bins, double pointSigmaFrequency, double narrowest, double widest, double farthest) {
        this.stride = bins.stride();
        Plane first = Plane.empty(narrowest, farthest, stride);
        double share = Math.pow(pointSigmaFrequency / narrowest, 2);
        sum(
                bins.powers(),
                bins.columns(),
                bins.rows(),
                first,
                new Lines(narrowest, bins.periodX(), bins.firstX()),
                new Lines(narrowest, bins.periodY(), bins.firstY()),
                share);
        planes.add(first);
        while (planes.size() < 2 || planes.get(planes.size() - 1).sigmaFrequency < widest) {
            planes.add(wider(planes.get(planes.size() - 1), farthest));
        }
    }

    /** Gaussians over nodes along one axis: nodes per unit of frequency (meters), number of the first node. */
    private record Lines(double sigmaFrequency, double perFrequency, double first) {
        GaussianWeights weights() {
            return new GaussianWeights(1 / (sigmaFrequency * perFrequency), REACH);
        }
    }

    private Plane wider(Plane before, double farthest) {
        Plane next = Plane.empty(RATIO * before.sigmaFrequency, farthest, stride);
        double blur = before.sigmaFrequency * Math.sqrt(RATIO * RATIO - 1);
        double[] powers = new double[before.powers.length];
        for (int i = 0; i < powers.length; i++) {
            powers[i] = before.powers[i];
        }
        Lines lines = new Lines(blur, 1 / before.spacing, -before.half);
        double share = Math.pow(before.spacing / blur, 2) / Math.PI;
        sum(powers, before.side(), before.side(), next, lines, lines, share);
        return next;
    }

    private void sum(double[] from, int columns, int rows, Plane to, Lines alongX, Lines alongY, double share) {
        int side = to.side();
        double[] lines = new double[rows * side * stride];
        IntStream.range(0, side).parallel().forEach(column -> {
            GaussianWeights x = alongX.weights();
            x.moveTo((column - to.half) * to.spacing * alongX.perFrequency - alongX.first, 0, columns - 1);
            for (int row = 0; row < rows; row++) {
                int at = (row * side + column) * stride;
                for (int i = 0; i < x.count(); i++) {
                    int read = (row * columns + x.first() + i) * stride;
                    for (int m = 0; m < stride; m++) {
                        lines[at + m] += x.weights()[i] * from[read + m];
                    }
                }
            }
        });
        IntStream.range(0, side).parallel().forEach(row -> {
            GaussianWeights y = alongY.weights();
            y.moveTo((row - to.half) * to.spacing * alongY.perFrequency - alongY.first, 0, rows - 1);
            double[] sums = new double[side * stride];
            for (int j = 0; j < y.count(); j++) {
                int read = (y.first() + j) * side * stride;
                for (int i = 0; i < sums.length; i++) {
                    sums[i] += y.weights()[j] * lines[read + i];
                }
            }
            for (int i = 0; i < sums.length; i++) {
                to.powers[row * side * stride + i] = (float) (share * sums[i]);
            }
        });
    }

    /** Returns the number of values per node: the terms, padded with zeros. */
    int stride() {
        return stride;
    }

    int count() {
        return planes.size();
    }

    /** Returns the fractional index of the plane of a sigma_f, clamped. */
    double place(double sigmaFrequency) {
        double place = Math.log(sigmaFrequency / planes.get(0).sigmaFrequency) / Math.log(RATIO);
        return Math.max(0, Math.min(planes.size() - 1.001, place));
    }

    /**
     * Interpolates the terms at a frequency in the planes {@code first .. end - 1}.
     *
     * @param x frequency along x, cycles per meter
     * @param terms output, {@link #stride} values per plane
     */
    void at(double x, double y, int first, int end, float[] terms) {
        float[] wx = new float[TAPS];
        float[] wy = new float[TAPS];
        for (int window = first; window < end; window++) {
            Plane plane = planes.get(window);
            int column = taps(x / plane.spacing + plane.half, plane.side(), wx);
            int row = taps(y / plane.spacing + plane.half, plane.side(), wy);
            int to = (window - first) * stride;
            Arrays.fill(terms, to, to + stride, 0);
            for (int j = 0; j < TAPS; j++) {
                int from = ((row + j) * plane.side() + column) * stride;
                add(plane.powers, from, wy[j], wx, terms, to);
            }
        }
    }

    private void add(float[] powers, int from, float weight, float[] weights, float[] terms, int to) {
        float w0 = weight * weights[0];
        float w1 = weight * weights[1];
        float w2 = weight * weights[2];
        float w3 = weight * weights[3];
        int second = from + stride;
        int third = second + stride;
        int fourth = third + stride;
        for (int m = 0; m < stride; m++) {
            terms[to + m] +=
                    w0 * powers[from + m] + w1 * powers[second + m] + w2 * powers[third + m] + w3 * powers[fourth + m];
        }
    }

    /** Computes the Lagrange weights of the four nodes around a position, and returns the first. */
    private static int taps(double place, int side, float[] weights) {
        int first = Math.max(0, Math.min((int) Math.floor(place) - 1, side - TAPS));
        double t0 = place - first;
        double t1 = t0 - 1;
        double t2 = t0 - 2;
        double t3 = t0 - 3;
        weights[0] = (float) (-t1 * t2 * t3 / 6);
        weights[1] = (float) (t0 * t2 * t3 / 2);
        weights[2] = (float) (-t0 * t1 * t3 / 2);
        weights[3] = (float) (t0 * t1 * t2 / 6);
        return first;
    }
}
