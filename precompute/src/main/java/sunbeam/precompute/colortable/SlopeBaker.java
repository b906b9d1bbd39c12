package sunbeam.precompute.colortable;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.spectrum.PowerSpectrum;

/**
 * Bakes colors of a surface with relief finer than a pixel: means of the ensemble average over normally distributed slopes, each of which
 * shifts (u, v) by slope times w. At one wavelength and w this is the ensemble average under a shorter window (docs/color-tables.md).
 * Thread-safe.
 */
public record SlopeBaker(PowerSpectrum spectrum, CieTable cie, GaussianPyramid pyramid, ColorTable table, int level)
        implements ColorBaker {
    private static final int COLORS = 3;
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

    /** Builds the pyramid that all levels of a table with slopes share; takes tenths of a second. */
    public static GaussianPyramid pyramid(PowerSpectrum spectrum, ColorTable table) {
        int coarsest = table.levels().size() - 1;
        return new GaussianPyramid(
                spectrum,
                table.area().window().sigmaFrequency(),
                sigmaFrequency(table, 0, 0, CieTable.MAXIMUM_WAVELENGTH),
                sigmaFrequency(table, coarsest, ColorTable.DEEPEST, CieTable.MINIMUM_WAVELENGTH),
                FARTHEST / CieTable.MINIMUM_WAVELENGTH);
    }

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
        float[][] factors = new float[nodes.count()][GaussianPyramid.TAPS * pyramid.stride()];
        float[] weights = new float[GaussianPyramid.TAPS];
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            double[] coefficients = spectrum.coefficients(wavelength, depth);
            planes[i] = pyramid.taps(sigmaFrequency(table, level, depth, wavelength), weights);
            for (int tap = 0; tap < GaussianPyramid.TAPS; tap++) {
                for (int m = 0; m < coefficients.length; m++) {
                    factors[i][tap * pyramid.stride() + m] = (float) (weights[tap] * coefficients[m]);
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
        float[] terms = new float[pyramid.count() * pyramid.stride()];
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
                int ofSlice = (slices[j].planes[i] - first) * pyramid.stride();
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
}
