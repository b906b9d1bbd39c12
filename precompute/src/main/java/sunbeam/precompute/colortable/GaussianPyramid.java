package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.Interpolation.SplineFilter;
import sunbeam.precompute.colortable.WindowedSpectrum.GaussianWeights;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.spectrum.PowerSpectrum.Axis;

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

    /** Values of the terms at a frequency, and their first and second radial derivatives times the radius and its square. */
    record Terms(float[] values, float[] slopes, float[] bends) {
        Terms(int count) {
            this(new float[count], new float[count], new float[count]);
        }
    }

    Terms terms() {
        return new Terms(planes.size() * stride);
    }

    int stride() {
        return stride;
    }

    /** Builds the planes for all levels of a table with slopes; takes tenths of a second. Sums under its point's window are not divided. */
    public GaussianPyramid(PowerSpectrum bins, ColorTable table) {
        double narrowest = SlopeBaker.sigmaFrequency(table, 0, 0, CieTable.MAXIMUM_WAVELENGTH);
        int coarsest = table.levels().size() - 1;
        double widest = SlopeBaker.sigmaFrequency(table, coarsest, ColorTable.DEEPEST, CieTable.MINIMUM_WAVELENGTH);
        double farthest = SlopeBaker.FARTHEST / CieTable.MINIMUM_WAVELENGTH;
        double share = Math.pow(table.area().window().sigmaFrequency() / narrowest, 2);
        this.stride = bins.stride();
        float[] powers = Floats.of(bins.powers().length, i -> bins.powers()[i]);
        Plane plane = Plane.empty(narrowest, farthest, stride);
        sum(powers, bins.x(), bins.y(), narrowest, plane, share);
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
            sum(from, y.first * line.length, line.length, y, share, line, 0);
            GaussianWeights x = new GaussianWeights(alongX, sigmaFrequency, REACH);
            for (int column = 0; column < side; column++) {
                x.moveTo(alongX.place((column - to.half) * to.spacing), 0, alongX.count() - 1);
                sum(line, x.first * stride, stride, x, 1, to.powers, (row * side + column) * stride);
            }
        });
    }

    /** Adds the weighted runs of {@code length} values, from {@code first} on, to those at {@code at}: four runs at a time. */
    private static void sum(
            float[] from, int first, int length, GaussianWeights runs, double share, float[] to, int at) {
        double[] weights = runs.weights;
        int run = 0;
        int first0 = first;
        for (; run + TAPS <= runs.count; run += TAPS, first0 += TAPS * length) {
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
        for (; run < runs.count; run++, first0 += length) {
            float weight = (float) (share * weights[run]);
            for (int i = 0; i < length; i++) {
                to[at + i] += weight * from[first0 + i];
            }
        }
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

    /** Interpolates {@code stride} terms per plane, in planes {@code first .. end - 1}, at a frequency in cycles per meter. */
    void at(double frequencyX, double frequencyY, int first, int end, Terms terms) {
        for (int i = first; i < end; i++) {
            Plane plane = planes.get(i);
            double column = node(frequencyX, plane);
            double row = node(frequencyY, plane);
            Spline x = Spline.at(column);
            Spline y = Spline.at(row);
            // The radius, in nodes.
            float alongX = (float) (column - plane.half);
            float alongY = (float) (row - plane.half);
            int above = (((int) (row - 0.5)) * plane.side() + ((int) (column - 0.5))) * stride;
            interpolate(plane.powers, above, plane.side() * stride, x, y, alongX, alongY, terms, (i - first) * stride);
        }
    }

    /** Interpolates the terms of nine nodes, three of each of three rows, from the term {@code to} on. */
    private void interpolate(
            float[] powers, int above, int width, Spline x, Spline y, float alongX, float alongY, Terms terms, int to) {
        float squareX = alongX * alongX;
        float squareY = alongY * alongY;
        float mixed = 2 * alongX * alongY;
        for (int m = 0; m < stride; m++) {
            int at = above + m;
            float a0 = powers[at];
            float a1 = powers[at + stride];
            float a2 = powers[at + 2 * stride];
            at += width;
            float b0 = powers[at];
            float b1 = powers[at + stride];
            float b2 = powers[at + 2 * stride];
            at += width;
            float c0 = powers[at];
            float c1 = powers[at + stride];
            float c2 = powers[at + 2 * stride];
            float a = x.w0 * a0 + x.w1 * a1 + x.w2 * a2;
            float b = x.w0 * b0 + x.w1 * b1 + x.w2 * b2;
            float c = x.w0 * c0 + x.w1 * c1 + x.w2 * c2;
            float slopeA = x.slope0 * a0 + x.slope1 * a1 + x.slope2 * a2;
            float slopeB = x.slope0 * b0 + x.slope1 * b1 + x.slope2 * b2;
            float slopeC = x.slope0 * c0 + x.slope1 * c1 + x.slope2 * c2;
            float bend = y.w0 * (a0 - 2 * a1 + a2) + y.w1 * (b0 - 2 * b1 + b2) + y.w2 * (c0 - 2 * c1 + c2);
            terms.values[to + m] = y.w0 * a + y.w1 * b + y.w2 * c;
            terms.slopes[to + m] = alongX * (y.w0 * slopeA + y.w1 * slopeB + y.w2 * slopeC)
                    + alongY * (y.slope0 * a + y.slope1 * b + y.slope2 * c);
            terms.bends[to + m] = squareX * bend
                    + mixed * (y.slope0 * slopeA + y.slope1 * slopeB + y.slope2 * slopeC)
                    + squareY * (a - 2 * b + c);
        }
    }

    /** Weights of three nodes for a quadratic B-spline, and for its derivative by the node. */
    private record Spline(float w0, float w1, float w2, float slope0, float slope1, float slope2) {
        static Spline at(double place) {
            // Offset, -0.5 to 0.5, from the middle node.
            float x = (float) (place - (int) (place + 0.5));
            float before = 0.5f - x;
            float after = 0.5f + x;
            return new Spline(0.5f * before * before, 0.75f - x * x, 0.5f * after * after, -before, -2 * x, after);
        }
    }

    private static double node(double frequency, Plane plane) {
        return Math.max(1, Math.min(plane.side() - NODES + 1, frequency / plane.spacing + plane.half));
    }
}
