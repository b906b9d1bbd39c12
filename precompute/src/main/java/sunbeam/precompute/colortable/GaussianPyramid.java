package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.numerics.SplineFilter;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.spectrum.PowerSpectrum.Axis;
import sunbeam.precompute.spectrum.PowerSpectrum.GaussianWeights;

/**
 * Gaussian pyramid of a power spectrum. Each plane holds the spectrum's terms under one window on a grid of frequencies, blurred from the
 * plane of the next longer window. Sums over a Gaussian are divided by its area relative to the coherence window's: planes hold means.
 * Immutable.
 */
public final class GaussianPyramid {
    // From plane to plane: cubic interpolation between planes errs by 1 % on the faint flanks of orders.
    private static final double RATIO = 1.15;
    // In standard deviations of the Gaussian: quadratic B-splines err by 1e-3.
    private static final double SPACING = 0.5;
    private static final int NODES = 3;
    // In sigma_f: exp(-reach^2) = 1e-6.
    private static final double REACH = 3.7;
    static final int TAPS = 4;

    private final int stride;
    private final List<Plane> planes = new ArrayList<>();

    /**
     * Powers on a square grid around frequency 0, {@code [row][column][term]}; after {@link #prefilter} coefficients of B-splines. The grid
     * has {@code half} nodes on either side; widths and spacing are in cycles per meter.
     */
    private record Plane(double sigmaFrequency, double spacing, int half, float[] powers) {
        static Plane empty(double sigmaFrequency, double farthest, int stride) {
            double spacing = SPACING * sigmaFrequency / Math.sqrt(2);
            int half = (int) Math.ceil(farthest / spacing) + NODES - 1;
            int side = 2 * half + 1;
            return new Plane(sigmaFrequency, spacing, half, new float[side * side * stride]);
        }

        int side() {
            return 2 * half + 1;
        }

        void prefilter(int stride) {
            int width = side() * stride;
            SplineFilter.alongColumns(powers, side(), width, SplineFilter.QUADRATIC);
            IntStream.range(0, side()).parallel().forEach(row -> {
                float[] line = Arrays.copyOfRange(powers, row * width, (row + 1) * width);
                SplineFilter.alongColumns(line, side(), stride, SplineFilter.QUADRATIC);
                System.arraycopy(line, 0, powers, row * width, width);
            });
        }
    }

    /** Windows have sigma_f from {@code narrowest} to {@code widest}; sums under that at a point are not divided; cycles per meter. */
    GaussianPyramid(PowerSpectrum bins, double pointSigmaFrequency, double narrowest, double widest, double farthest) {
        this.stride = bins.stride();
        float[] powers = new float[bins.powers().length];
        for (int i = 0; i < powers.length; i++) {
            powers[i] = (float) bins.powers()[i];
        }
        Plane plane = Plane.empty(narrowest, farthest, stride);
        sum(powers, bins.x(), bins.y(), narrowest, plane, Math.pow(pointSigmaFrequency / narrowest, 2));
        planes.add(plane);
        while (planes.size() < TAPS || plane.sigmaFrequency < widest) {
            Plane before = plane;
            plane = Plane.empty(RATIO * before.sigmaFrequency, farthest, stride);
            double blur = before.sigmaFrequency * Math.sqrt(RATIO * RATIO - 1);
            Axis nodes = new Axis(1 / before.spacing, -before.half, before.side());
            sum(before.powers, nodes, nodes, blur, plane, Math.pow(before.spacing / blur, 2) / Math.PI);
            before.prefilter(stride);
            planes.add(plane);
        }
        plane.prefilter(stride);
    }

    private void sum(float[] from, Axis alongX, Axis alongY, double sigmaFrequency, Plane to, double share) {
        int side = to.side();
        IntStream.range(0, side).parallel().forEach(row -> {
            GaussianWeights y = new GaussianWeights(alongY, sigmaFrequency, REACH);
            y.moveTo(alongY.place((row - to.half) * to.spacing), 0, alongY.count() - 1);
            float[] line = new float[alongX.count() * stride];
            sum(from, y.first() * line.length, line.length, y, share, line, 0);
            GaussianWeights x = new GaussianWeights(alongX, sigmaFrequency, REACH);
            for (int column = 0; column < side; column++) {
                x.moveTo(alongX.place((column - to.half) * to.spacing), 0, alongX.count() - 1);
                sum(line, x.first() * stride, stride, x, 1, to.powers, (row * side + column) * stride);
            }
        });
    }

    /** Adds the weighted runs of {@code length} values, from {@code first} on, to those at {@code at}: four runs at a time. */
    private static void sum(
            float[] from, int first, int length, GaussianWeights runs, double share, float[] to, int at) {
        double[] weights = runs.weights();
        int run = 0;
        int first0 = first;
        for (; run + TAPS <= runs.count(); run += TAPS, first0 += TAPS * length) {
            float w0 = (float) (share * weights[run]);
            float w1 = (float) (share * weights[run + 1]);
            float w2 = (float) (share * weights[run + 2]);
            float w3 = (float) (share * weights[run + 3]);
            int first1 = first0 + length;
            int first2 = first1 + length;
            int first3 = first2 + length;
            for (int i = 0; i < length; i++) {
                to[at + i] +=
                        w0 * from[first0 + i] + w1 * from[first1 + i] + w2 * from[first2 + i] + w3 * from[first3 + i];
            }
        }
        for (; run < runs.count(); run++, first0 += length) {
            float weight = (float) (share * weights[run]);
            for (int i = 0; i < length; i++) {
                to[at + i] += weight * from[first0 + i];
            }
        }
    }

    int stride() {
        return stride;
    }

    int count() {
        return planes.size();
    }

    /** Returns the first of the {@link #TAPS} planes around a sigma_f, and computes their Lagrange weights. */
    int taps(double sigmaFrequency, float[] weights) {
        double fraction = Math.log(sigmaFrequency / planes.get(0).sigmaFrequency) / Math.log(RATIO);
        double place = Math.max(0, Math.min(planes.size() - 1, fraction));
        int first = Math.max(0, Math.min((int) place - 1, planes.size() - TAPS));
        for (int tap = 0; tap < TAPS; tap++) {
            weights[tap] = (float) Lagrange.weight(place - first, tap, TAPS);
        }
        return first;
    }

    /** Interpolates {@link #stride} terms per plane, in planes {@code first .. end - 1}, at a frequency in cycles per meter. */
    void at(double frequencyX, double frequencyY, int first, int end, float[] terms) {
        for (int i = first; i < end; i++) {
            Plane plane = planes.get(i);
            float[] powers = plane.powers;
            double column = node(frequencyX, plane);
            double row = node(frequencyY, plane);
            int width = plane.side() * stride;
            // Weights of nine nodes, by the offsets, -0.5 to 0.5, from the middle one.
            float x = (float) (column - (int) (column + 0.5));
            float y = (float) (row - (int) (row + 0.5));
            float x0 = 0.5f * (0.5f - x) * (0.5f - x);
            float x1 = 0.75f - x * x;
            float x2 = 1 - x0 - x1;
            float y0 = 0.5f * (0.5f - y) * (0.5f - y);
            float y1 = 0.75f - y * y;
            float y2 = 1 - y0 - y1;
            int above = (((int) (row - 0.5)) * plane.side() + ((int) (column - 0.5))) * stride;
            int to = (i - first) * stride;
            for (int m = 0; m < stride; m++, above++) {
                int middle = above + width;
                int below = middle + width;
                terms[to + m] = y0
                                * (x0 * powers[above] + x1 * powers[above + stride] + x2 * powers[above + 2 * stride])
                        + y1 * (x0 * powers[middle] + x1 * powers[middle + stride] + x2 * powers[middle + 2 * stride])
                        + y2 * (x0 * powers[below] + x1 * powers[below + stride] + x2 * powers[below + 2 * stride]);
            }
        }
    }

    private static double node(double frequency, Plane plane) {
        return Math.max(1, Math.min(plane.side() - NODES + 1, frequency / plane.spacing + plane.half));
    }
}
