package sunbeam.precompute.colortable;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.work.Progress;

/**
 * Bakes colors of a surface with relief finer than a pixel: means of the ensemble average over normally distributed slopes s, each of which
 * turns (u, v, w) to (u, v) - s w and w + s . (u, v) (docs/color-tables.md). At one wavelength and w the former is the ensemble average Q under
 * a shorter window. The latter is expanded to second order: with W = -w, the slopes' variance V and coefficients c(W),
 *
 * <pre>mean = c Q - V W c' D Q + V / 2 c'' (r^2 Q + V W^2 D2 Q),   D = r d/dr, D2 = r^2 d^2/dr^2 along r = |(u, v)|</pre>
 *
 * by the identity E[s F(u + s W)] = V W grad E[F(u + s W)] of normal distributions. Thread-safe.
 */
public record SlopeBaker(PowerSpectrum spectrum, CieTable cie, GaussianPyramid pyramid, ColorTable table, int level)
        implements ColorBaker {
    /** Largest |(u, v)|, slightly beyond all directions. */
    static final double FARTHEST = 2.2;
    /** Step of ln lambda where orders are wide. */
    private static final double WIDEST_STEP = 0.06;
    /** The same in units of sigma_f / |f|, where orders are narrow. */
    private static final double ORDER_STEP = 0.9;
    /** Least weight of a wavelength, relative to white. */
    private static final double LEAST_WEIGHT = 1e-5;

    // Step of |w| for derivatives of coefficients, whose phase it changes by less than a tenth up to 2 um of relief.
    private static final double DEPTH_STEP = 4e-3;

    /** Wavelengths of a step, and per slice of |w| its sums over terms. */
    private record Nodes(WavelengthNodes wavelengths, Map<Double, Slice> slices) {}

    /**
     * Slice of one |w|: per wavelength the first of the planes around its sigma_f, and for each term of these the factors c, -V W c' and
     * V c'' / 2.
     */
    private record Slice(int[] planes, float[][] factors, float[][] tilts, float[][] bends) {
        /** Sums the terms from an index on, for a square of |(u, v)| and a variance of its shift by slopes. */
        double power(int wavelength, GaussianPyramid.Terms terms, int from, float square, float shift) {
            float[] factor = factors[wavelength];
            float[] tilt = tilts[wavelength];
            float[] bend = bends[wavelength];
            double power = 0;
            for (int m = 0; m < factor.length; m++) {
                float value = terms.values()[from + m];
                power += factor[m] * value
                        + tilt[m] * terms.slopes()[from + m]
                        + bend[m] * (square * value + shift * terms.bends()[from + m]);
            }
            return power;
        }
    }

    static double sigmaFrequency(ColorTable table, int level, double depth, double wavelength) {
        return table.widened(table.slopeVariance(level, depth), wavelength).sigmaFrequency();
    }

    @Override
    public float[] bake(float[] uvw, Progress token) {
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
        int length = GaussianPyramid.TAPS * pyramid.stride();
        Slice slice = new Slice(
                new int[nodes.count()],
                new float[nodes.count()][length],
                new float[nodes.count()][length],
                new float[nodes.count()][length]);
        float[] weights = new float[GaussianPyramid.TAPS];
        double variance = variance();
        // A turned w is shorter in the mean.
        double turned = (1 - variance) * depth;
        double middle = Math.max(DEPTH_STEP, Math.min(ColorTable.DEEPEST - DEPTH_STEP, turned));
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            double[] coefficients = spectrum.coefficients(wavelength, turned);
            double[] before = spectrum.coefficients(wavelength, middle - DEPTH_STEP);
            double[] here = spectrum.coefficients(wavelength, middle);
            double[] after = spectrum.coefficients(wavelength, middle + DEPTH_STEP);
            slice.planes[i] = pyramid.taps(sigmaFrequency(table, level, depth, wavelength), weights);
            for (int tap = 0; tap < GaussianPyramid.TAPS; tap++) {
                for (int m = 0; m < coefficients.length; m++) {
                    int at = tap * pyramid.stride() + m;
                    double slope = (after[m] - before[m]) / (2 * DEPTH_STEP);
                    double bend = (after[m] - 2 * here[m] + before[m]) / (DEPTH_STEP * DEPTH_STEP);
                    slice.factors[i][at] = (float) (weights[tap] * coefficients[m]);
                    slice.tilts[i][at] = (float) (-variance * depth * weights[tap] * slope);
                    slice.bends[i][at] = (float) (0.5 * variance * weights[tap] * bend);
                }
            }
        }
        return slice;
    }

    private double variance() {
        return table.slopeDeviation() * table.slopeDeviation();
    }

    private void bake(Nodes nodes, float[] uvw, int from, int to, float[] xyz) {
        Slice[] slices = new Slice[to - from];
        for (int i = 0; i < slices.length; i++) {
            double depth = Math.abs(uvw[COLORS * (from + i) + 2]);
            slices[i] = RadialBaker.known(nodes.slices, depth, key -> slice(nodes.wavelengths, key));
        }
        double[] sums = new double[COLORS * slices.length];
        GaussianPyramid.Terms terms = pyramid.terms();
        // Turned axes are shorter in the mean.
        double turned = 1 - 0.5 * variance();
        float square = (float) (Math.pow(uvw[COLORS * from], 2) + Math.pow(uvw[COLORS * from + 1], 2));
        for (int i = 0; i < nodes.wavelengths.count(); i++) {
            double wavelength = nodes.wavelengths.wavelengths()[i];
            double[] weights = nodes.wavelengths.weights()[i];
            int first = Integer.MAX_VALUE;
            int end = 0;
            for (Slice slice : slices) {
                first = Math.min(first, slice.planes[i]);
                end = Math.max(end, slice.planes[i] + GaussianPyramid.TAPS);
            }
            double frequency = turned / wavelength;
            pyramid.at(frequency * uvw[COLORS * from], frequency * uvw[COLORS * from + 1], first, end, terms);
            for (int j = 0; j < slices.length; j++) {
                int ofSlice = (slices[j].planes[i] - first) * pyramid.stride();
                float blur = (float) (variance() * Math.pow(uvw[COLORS * (from + j) + 2], 2));
                double power = slices[j].power(i, terms, ofSlice, square, blur);
                for (int c = 0; c < COLORS; c++) {
                    sums[COLORS * j + c] += power * weights[c];
                }
            }
        }
        for (int i = 0; i < sums.length; i++) {
            xyz[COLORS * from + i] = (float) Math.max(0, sums[i]);
        }
    }
}
