package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.colortable.Interpolation.SplineFilter;
import sunbeam.precompute.colortable.WindowedSpectrum.GaussianWeights;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.spectrum.PowerSpectrum.Axis;

/**
 * Bakes colors of a surface with relief finer than a pixel: means of the ensemble average over normally distributed slopes, each of which
 * shifts (u, v) by slope times w. At one wavelength and w this is the ensemble average under a shorter window (docs/color-tables.md).
 * Thread-safe.
 */
public record SlopeBaker(
        PowerSpectrum spectrum, CieTable cie, SlopeBaker.GaussianPyramid pyramid, ColorTable table, int level)
        implements ColorBaker {
    /** Largest |(u, v)|, slightly beyond all directions. */
    private static final double FARTHEST = 2.2;
    /** Step of ln lambda where orders are wide. */
    private static final double WIDEST_STEP = 0.06;
    /** The same in units of sigma_f / |f|, where orders are narrow. */
    private static final double ORDER_STEP = 0.9;
    /** Least weight of a wavelength, relative to white. */
    private static final double LEAST_WEIGHT = 1e-5;

    /** Wavelengths of a step, and per slice of |w| its sums over terms. */
    private record Nodes(WavelengthNodes wavelengths, Map<Double, Slice> slices) {}

    /** Slice of one |w|: per wavelength the first of the planes around its sigma_f, and a factor for each term of these. */
    private record Slice(int[] planes, float[][] factors) {}

    private static double sigmaFrequency(ColorTable table, int level, double depth, double wavelength) {
        return table.widened(table.slopeVariance(level, depth), wavelength).sigmaFrequency();
    }

    @Override
    public float[] bake(float[] uvw, ColorBaker.Token token) {
        float[] xyz = new float[uvw.length];
        int[] columns = RadialBaker.DirectBaker.columns(uvw);
        Map<Integer, Nodes> nodes = new ConcurrentHashMap<>();
        IntStream.range(0, columns.length - 1).parallel().forEach(column -> {
            int end;
            for (int first = columns[column]; first < columns[column + 1]; first = end) {
                int halvings = halvings(uvw, first);
                end = first + 1;
                while (end < columns[column + 1] && halvings(uvw, end) == halvings) {
                    end++;
                }
                bake(RadialBaker.known(nodes, halvings, this::nodes), uvw, first, end, xyz);
            }
            token.step(columns[column + 1] - columns[column]);
        });
        return xyz;
    }

    private int halvings(float[] uvw, int sample) {
        double radius = Math.hypot(uvw[COLORS * sample], uvw[COLORS * sample + 1]);
        double depth = Math.abs(uvw[COLORS * sample + 2]);
        // Relief widens orders least at the shortest wavelength.
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        double order = sigmaFrequency(table, level, depth, shortest) * shortest / radius;
        return RadialBaker.DirectBaker.halvings(WIDEST_STEP, ORDER_STEP * order);
    }

    private Nodes nodes(int halvings) {
        double step = WIDEST_STEP / (1 << halvings);
        return new Nodes(WavelengthNodes.logarithmic(cie, step, LEAST_WEIGHT), new ConcurrentHashMap<>());
    }

    private Slice slice(WavelengthNodes nodes, double depth) {
        int[] planes = new int[nodes.count()];
        float[][] factors = new float[nodes.count()][GaussianPyramid.TAPS * pyramid.stride];
        float[] weights = new float[GaussianPyramid.TAPS];
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            double[] coefficients = spectrum.coefficients(wavelength, depth);
            planes[i] = pyramid.taps(sigmaFrequency(table, level, depth, wavelength), weights);
            for (int tap = 0; tap < GaussianPyramid.TAPS; tap++) {
                for (int m = 0; m < coefficients.length; m++) {
                    factors[i][tap * pyramid.stride + m] = (float) (weights[tap] * coefficients[m]);
                }
            }
        }
        return new Slice(planes, factors);
    }

    private void bake(Nodes nodes, float[] uvw, int from, int to, float[] xyz) {
        Slice[] slices = new Slice[to - from];
        for (int i = 0; i < slices.length; i++) {
            double depth = Math.abs(uvw[COLORS * (from + i) + 2]);
            slices[i] = RadialBaker.known(nodes.slices, depth, key -> slice(nodes.wavelengths, key));
        }
        double[] sums = new double[COLORS * slices.length];
        float[] terms = new float[pyramid.planes.size() * pyramid.stride];
        for (int i = 0; i < nodes.wavelengths.count(); i++) {
            double wavelength = nodes.wavelengths.wavelengths()[i];
            double[] weights = nodes.wavelengths.weights()[i];
            int first = Integer.MAX_VALUE;
            int end = 0;
            for (Slice slice : slices) {
                first = Math.min(first, slice.planes[i]);
                end = Math.max(end, slice.planes[i] + GaussianPyramid.TAPS);
            }
            pyramid.at(uvw[COLORS * from] / wavelength, uvw[COLORS * from + 1] / wavelength, first, end, terms);
            for (int j = 0; j < slices.length; j++) {
                float[] factors = slices[j].factors[i];
                int ofSlice = (slices[j].planes[i] - first) * pyramid.stride;
                double power = 0;
                for (int m = 0; m < factors.length; m++) {
                    power += factors[m] * terms[ofSlice + m];
                }
                for (int c = 0; c < COLORS; c++) {
                    sums[COLORS * j + c] += power * weights[c];
                }
            }
        }
        for (int i = 0; i < sums.length; i++) {
            xyz[COLORS * from + i] = (float) Math.max(0, sums[i]);
        }
    }

    /**
     * Gaussian pyramid of a power spectrum. Each plane holds the spectrum's terms under one window on a grid of frequencies, blurred from the
     * plane of the next longer window. Sums over a Gaussian are divided by its area relative to the coherence window's: planes hold means.
     * Immutable.
     */
    public static final class GaussianPyramid {
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

        /** Builds the planes for all levels of a table with slopes; takes tenths of a second. Sums under its point's window are not divided. */
        public GaussianPyramid(PowerSpectrum bins, ColorTable table) {
            double narrowest = sigmaFrequency(table, 0, 0, CieTable.MAXIMUM_WAVELENGTH);
            int coarsest = table.levels().size() - 1;
            double widest = sigmaFrequency(table, coarsest, ColorTable.DEEPEST, CieTable.MINIMUM_WAVELENGTH);
            double farthest = FARTHEST / CieTable.MINIMUM_WAVELENGTH;
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
                    to[at + i] += w0 * from[first0 + i]
                            + w1 * from[first1 + i]
                            + w2 * from[first2 + i]
                            + w3 * from[first3 + i];
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
                                    * (x0 * powers[above]
                                            + x1 * powers[above + stride]
                                            + x2 * powers[above + 2 * stride])
                            + y1
                                    * (x0 * powers[middle]
                                            + x1 * powers[middle + stride]
                                            + x2 * powers[middle + 2 * stride])
                            + y2 * (x0 * powers[below] + x1 * powers[below + stride] + x2 * powers[below + 2 * stride]);
                }
            }
        }

        private static double node(double frequency, Plane plane) {
            return Math.max(1, Math.min(plane.side() - NODES + 1, frequency / plane.spacing + plane.half));
        }
    }
}
