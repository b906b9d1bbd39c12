package sunbeam.precompute.radial;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.colortable.BakeToken;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;

/**
 * Bakes colors of a surface with relief finer than a pixel: means of the ensemble average over normally distributed slopes, each of which
 * shifts (u, v) by slope times w. At one wavelength and w this mean is the ensemble average under a shorter window (docs/color-tables.md).
 * Thread-safe.
 */
public final class SlopeBaker implements ColorBaker {
    private static final int COLORS = 3;
    /** Largest |(u, v)|, slightly beyond all directions. */
    private static final double FARTHEST = 2.2;
    /** Step of ln lambda where orders are wide. */
    private static final double WIDEST_STEP = 0.02;
    /** The same in units of sigma_f / |f|, where orders are narrow. */
    private static final double ORDER_STEP = 0.6;

    private final PowerSpectrum spectrum;
    private final CieTable cie;
    private final GaussianPyramid pyramid;
    private final ColorTable table;
    private final int level;
    private final double orderStep;

    /** Slice of one |w|: per wavelength the fractional index of a plane of the pyramid, and the terms' coefficients. */
    private record Slice(double[] places, double[][] coefficients) {}

    private record SliceKey(int halvings, double depth) {}

    /** @param pyramid pyramid that {@link #pyramid(PowerSpectrum, ColorTable)} returns for the table */
    public SlopeBaker(PowerSpectrum spectrum, CieTable cie, GaussianPyramid pyramid, ColorTable table, int level) {
        this.spectrum = spectrum;
        this.cie = cie;
        this.pyramid = pyramid;
        this.table = table;
        this.level = level;
        // Relief widens orders least at the shortest wavelength.
        this.orderStep =
                ORDER_STEP * sigmaFrequency(table, level, 0, CieTable.MINIMUM_WAVELENGTH) * CieTable.MINIMUM_WAVELENGTH;
    }

    /** Builds the pyramid that all levels of a table with slopes share; takes tenths of a second. */
    public static GaussianPyramid pyramid(PowerSpectrum spectrum, ColorTable table) {
        int coarsest = table.levels().size() - 1;
        return spectrum.pyramid(
                table.area().window().sigmaFrequency(),
                sigmaFrequency(table, 0, 0, CieTable.MAXIMUM_WAVELENGTH),
                sigmaFrequency(table, coarsest, ColorTable.DEEPEST, CieTable.MINIMUM_WAVELENGTH),
                FARTHEST / CieTable.MINIMUM_WAVELENGTH);
    }

    private static double sigmaFrequency(ColorTable table, int level, double depth, double wavelength) {
        return table.widened(table.slopeVariance(level, depth), wavelength).sigmaFrequency();
    }

    @Override
    public float[] bake(float[] uvw, BakeToken token) {
        float[] xyz = new float[uvw.length];
        int[] columns = DirectBaker.columns(uvw);
        Map<Integer, WavelengthNodes> nodes = new ConcurrentHashMap<>();
        Map<SliceKey, Slice> slices = new ConcurrentHashMap<>();
        IntStream.range(0, columns.length - 1).parallel().forEach(column -> {
            int first = columns[column];
            int halvings = DirectBaker.halvings(
                    WIDEST_STEP, orderStep / Math.hypot(uvw[COLORS * first], uvw[COLORS * first + 1]));
            WavelengthNodes wavelengths = nodes.get(halvings);
            if (wavelengths == null) {
                // Two threads may compute the same nodes or slice; neither waits.
                wavelengths = IntegratedNodes.logarithmic(cie, WIDEST_STEP / (1 << halvings));
                nodes.put(halvings, wavelengths);
            }
            Slice[] own = new Slice[columns[column + 1] - first];
            for (int i = 0; i < own.length; i++) {
                SliceKey key = new SliceKey(halvings, Math.abs(uvw[COLORS * (first + i) + 2]));
                own[i] = slices.get(key);
                if (own[i] == null) {
                    own[i] = slice(wavelengths, key.depth);
                    slices.put(key, own[i]);
                }
            }
            put(wavelengths, own, uvw[COLORS * first], uvw[COLORS * first + 1], xyz, COLORS * first);
            token.step(own.length);
        });
        return xyz;
    }

    private Slice slice(WavelengthNodes nodes, double depth) {
        double[] places = new double[nodes.count()];
        double[][] coefficients = new double[nodes.count()][];
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            places[i] = pyramid.place(sigmaFrequency(table, level, depth, wavelength));
            coefficients[i] = spectrum.coefficients(wavelength, depth);
        }
        return new Slice(places, coefficients);
    }

    private void put(WavelengthNodes nodes, Slice[] slices, double u, double v, float[] xyz, int at) {
        double[] sums = new double[COLORS * slices.length];
        float[] terms = new float[pyramid.count() * pyramid.stride()];
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            int first = Integer.MAX_VALUE;
            int end = 0;
            for (Slice slice : slices) {
                first = Math.min(first, (int) slice.places[i]);
                end = Math.max(end, 2 + (int) slice.places[i]);
            }
            pyramid.at(u / wavelength, v / wavelength, first, end, terms);
            for (int j = 0; j < slices.length; j++) {
                double power = power(terms, slices[j].places[i] - first, slices[j].coefficients[i]);
                for (int c = 0; c < COLORS; c++) {
                    sums[COLORS * j + c] += power * nodes.weights()[i][c];
                }
            }
        }
        for (int i = 0; i < sums.length; i++) {
            xyz[at + i] = (float) Math.max(0, sums[i]);
        }
    }

    private double power(float[] terms, double place, double[] coefficients) {
        int below = (int) place;
        double share = place - below;
        int at = below * pyramid.stride();
        double power = 0;
        for (int m = 0; m < coefficients.length; m++) {
            power += coefficients[m] * ((1 - share) * terms[at + m] + share * terms[at + pyramid.stride() + m]);
        }
        return power;
    }
}
