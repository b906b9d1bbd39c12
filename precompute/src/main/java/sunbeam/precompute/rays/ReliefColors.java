package sunbeam.precompute.rays;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.colortable.ColorColumns;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.ColorTable;

/**
 * Colors of the ensemble average of a surface with relief finer than a pixel: means over normally distributed slopes, each of which moves
 * (u, v) by itself times w. At one wavelength and w that is the ensemble average under a shorter window (docs/color-tables.md). Safe for use by
 * several threads.
 */
public final class ReliefColors implements ColorSource {
    private static final int COLORS = 3;
    // Of (u, v): a little beyond all directions.
    private static final double FARTHEST = 2.2;
    // Of ln lambda, where orders are wide; else beside sigma_f of the window as orders have it.
    private static final double WIDEST_STEP = 0.02;
    private static final double ORDER_STEP = 0.6;

    private final RaySpectrum spectrum;
    private final PowerLadder ladder;
    private final ColorTable table;
    private final int level;
    private final LongConsumer progress;
    // sigma_f of the shortest wavelength, where relief widens orders least.
    private final double narrowest;

    /** The wavelengths of a sum; and of some depths, ascending, and each wavelength the place on the ladder and the terms' coefficients. */
    private record Sum(WavelengthNodes nodes, double[][] places, double[][][] coefficients) {}

    /**
     * Colors of a level.
     *
     * @param ladder of {@link #ladder}
     * @param table of relief
     * @param progress told how many more places have been evaluated, by any thread; what it throws ends the evaluation
     */
    public ReliefColors(RaySpectrum spectrum, PowerLadder ladder, ColorTable table, int level, LongConsumer progress) {
        this.spectrum = spectrum;
        this.ladder = ladder;
        this.table = table;
        this.level = level;
        this.progress = progress;
        this.narrowest = sigmaFrequency(table, level, 0, CieTable.MINIMUM_WAVELENGTH);
    }

    /** What all levels of a table of relief are evaluated from: it takes some tenths of a second. */
    public static PowerLadder ladder(RaySpectrum spectrum, ColorTable table) {
        int coarsest = table.levels().size() - 1;
        return spectrum.ladder(
                table.area().window().sigmaFrequency(),
                sigmaFrequency(table, 0, 0, CieTable.MAXIMUM_WAVELENGTH),
                sigmaFrequency(table, coarsest, ColorTable.DEEPEST, CieTable.MINIMUM_WAVELENGTH),
                FARTHEST / CieTable.MINIMUM_WAVELENGTH);
    }

    private static double sigmaFrequency(ColorTable table, int level, double depth, double wavelength) {
        return table.widened(table.slopeVariance(level, depth), wavelength).sigmaFrequency();
    }

    @Override
    public float[] xyz(float[] places) {
        float[] xyz = new float[places.length];
        IntStream.range(0, places.length / COLORS).parallel().forEach(place -> {
            int at = COLORS * place;
            Sum sum = sum(halvings(places[at], places[at + 1]), Math.abs(places[at + 2]));
            double[] color = colors(sum, new int[1], 1, places[at], places[at + 1])[0];
            for (int c = 0; c < COLORS; c++) {
                xyz[at + c] = (float) Math.max(0, color[c]);
            }
            progress.accept(1);
        });
        return xyz;
    }

    @Override
    public void evaluate(ColorColumns columns) {
        double[] depths = columns.depths();
        Map<Integer, Sum> sums = new ConcurrentHashMap<>();
        IntStream.range(0, columns.count()).parallel().forEach(column -> {
            int[] slices = new int[depths.length];
            int asked = columns.asked(column, slices);
            if (asked == 0) {
                return;
            }
            float[] uv = new float[2];
            columns.locate(column, uv);
            Sum sum = sums.computeIfAbsent(halvings(uv[0], uv[1]), halvings -> sum(halvings, depths));
            double[][] colors = colors(sum, slices, asked, uv[0], uv[1]);
            for (int i = 0; i < asked; i++) {
                columns.put(column, slices[i], colors[i][0], colors[i][1], colors[i][2]);
            }
            progress.accept(asked);
        });
    }

    /** How often the widest step is halved so that orders at a place are sampled. */
    private int halvings(double u, double v) {
        return DirectColors.halvings(
                WIDEST_STEP, ORDER_STEP * narrowest * CieTable.MINIMUM_WAVELENGTH / Math.hypot(u, v));
    }

    private Sum sum(int halvings, double... depths) {
        WavelengthNodes nodes = spectrum.wavelengths(WIDEST_STEP / (1 << halvings));
        double[][] places = new double[depths.length][nodes.count()];
        double[][][] coefficients = new double[depths.length][nodes.count()][];
        for (int depth = 0; depth < depths.length; depth++) {
            for (int i = 0; i < nodes.count(); i++) {
                double wavelength = nodes.wavelengths()[i];
                places[depth][i] = ladder.place(sigmaFrequency(table, level, depths[depth], wavelength));
                coefficients[depth][i] = spectrum.coefficients(wavelength, depths[depth]);
            }
        }
        return new Sum(nodes, places, coefficients);
    }

    /** X, Y, Z at some of the depths. */
    private double[][] colors(Sum sum, int[] depths, int count, double u, double v) {
        double[][] colors = new double[count][COLORS];
        float[] terms = new float[ladder.count() * ladder.stride()];
        for (int i = 0; i < sum.nodes.count(); i++) {
            double wavelength = sum.nodes.wavelengths()[i];
            // The deeper, the wider.
            int first = (int) sum.places[depths[0]][i];
            int end = 2 + (int) sum.places[depths[count - 1]][i];
            ladder.at(u / wavelength, v / wavelength, first, end, terms);
            for (int j = 0; j < count; j++) {
                double power = power(terms, sum.places[depths[j]][i] - first, sum.coefficients[depths[j]][i]);
                for (int c = 0; c < COLORS; c++) {
                    colors[j][c] += power * sum.nodes.weights()[i][c];
                }
            }
        }
        return colors;
    }

    /** Between two windows. */
    private double power(float[] terms, double place, double[] coefficients) {
        int below = (int) place;
        double share = place - below;
        int at = below * ladder.stride();
        double power = 0;
        for (int m = 0; m < coefficients.length; m++) {
            power += coefficients[m] * ((1 - share) * terms[at + m] + share * terms[at + ladder.stride() + m]);
        }
        return power;
    }
}
