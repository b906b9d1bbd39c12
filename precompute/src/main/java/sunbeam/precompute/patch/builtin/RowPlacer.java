package sunbeam.precompute.patch.builtin;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/** Draws the rows of a {@link FingerSkin}: lines, fingers and their deviations, periodic in both directions. */
final class RowPlacer {
    /** The density of the meander falls with the square of the frequency: slopes are alike on all scales. */
    private static final double WANDER_EXPONENT = 2;

    private final RowLayout layout;
    private final FingerShape shape;
    private final double side;
    private final int tableSize;
    private final SeededNoise noise;

    RowPlacer(RowLayout layout, FingerShape shape, double side, int tableSize, SeededNoise noise) {
        this.layout = layout;
        this.shape = shape;
        this.side = side;
        this.tableSize = tableSize;
        this.noise = noise;
    }

    FingerRow[] place() {
        int rows = layout.rows();
        double[] starts = places(normals(rows, layout.rowSpread()));
        int modesDown = Math.min(layout.wanderModesY(), (rows - 1) / 2);
        double[] wander = PeriodicField.powerLaw(
                tableSize, rows, layout.wander(), WANDER_EXPONENT, layout.wanderModesX(), modesDown, noise);
        double[][] centres = layout.coherenceRows() > 0 ? coherentCentres() : independentCentres();
        FingerRow[] placed = new FingerRow[rows];
        for (int row = 0; row < rows; row++) {
            double[] line = Arrays.copyOfRange(wander, row * tableSize, (row + 1) * tableSize);
            for (int i = 0; i < tableSize; i++) {
                line[i] += starts[row];
            }
            placed[row] = new FingerRow(fingers(centres[row]), line, side, shape);
        }
        return placed;
    }

    private List<FingerRow.Finger> fingers(double[] centres) {
        double[] tips = normals(centres.length, layout.tipSpread());
        double[] lifts = normals(centres.length, layout.heightSpread());
        return IntStream.range(0, centres.length)
                .mapToObj(i -> new FingerRow.Finger(centres[i], tips[i], lifts[i]))
                .toList();
    }

    private double[][] independentCentres() {
        double[][] centres = new double[layout.rows()][];
        for (int row = 0; row < centres.length; row++) {
            int count = (int) Math.max(3, Math.round(layout.fingers() + layout.countSpread() * noise.normal()));
            double offset = noise.uniform() * side;
            centres[row] = sortedWithin(places(normals(count, layout.fingerSpread())), offset);
        }
        return centres;
    }

    private double[][] coherentCentres() {
        double[][] deviations = new double[layout.rows()][];
        for (int row = 0; row < deviations.length; row++) {
            deviations[row] = normals(layout.fingers(), layout.fingerSpread());
        }
        double[][] smooth = smoothedOverRows(deviations, layout.coherenceRows());
        double[][] centres = new double[layout.rows()][];
        for (int row = 0; row < centres.length; row++) {
            double[] places = places(smooth[row]);
            centres[row] = sortedWithin(places, -meanDeviation(places));
        }
        return centres;
    }

    /** From a regular lattice; without it the first column would run dead straight through all rows. */
    private double meanDeviation(double[] places) {
        double sum = 0;
        for (int i = 0; i < places.length; i++) {
            sum += places[i] - i * side / places.length;
        }
        return sum / places.length;
    }

    /** Starts of intervals whose lengths deviate from their mean by the given fractions and together fill the side. */
    private double[] places(double[] deviations) {
        int count = deviations.length;
        double[] lengths = new double[count];
        double sum = 0;
        for (int i = 0; i < count; i++) {
            // A length below 40 % would turn two neighbors into one.
            lengths[i] = Math.max(0.4, 1 + deviations[i]);
            sum += lengths[i];
        }
        double[] starts = new double[count];
        double start = 0;
        for (int i = 0; i < count; i++) {
            starts[i] = start * side / sum;
            start += lengths[i];
        }
        return starts;
    }

    private double[] sortedWithin(double[] centres, double offset) {
        double[] moved = new double[centres.length];
        for (int i = 0; i < centres.length; i++) {
            moved[i] = (centres[i] + offset + side) % side;
        }
        Arrays.sort(moved);
        return moved;
    }

    private double[] normals(int count, double deviation) {
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = deviation * noise.normal();
        }
        return values;
    }

    /** Gaussian mean over neighboring rows, round the period, with the standard deviation restored. */
    private static double[][] smoothedOverRows(double[][] values, double sigma) {
        int rows = values.length;
        double[][] smooth = new double[rows][values[0].length];
        double[] weights = new double[rows];
        double squares = 0;
        for (int lag = 0; lag < rows; lag++) {
            double distance = Math.min(lag, rows - lag) / sigma;
            weights[lag] = StrictMath.exp(-distance * distance / 2);
            squares += weights[lag] * weights[lag];
        }
        double scale = 1 / StrictMath.sqrt(squares);
        for (int row = 0; row < rows; row++) {
            for (int lag = 0; lag < rows; lag++) {
                double[] other = values[(row + lag) % rows];
                for (int i = 0; i < other.length; i++) {
                    smooth[row][i] += scale * weights[lag] * other[i];
                }
            }
        }
        return smooth;
    }
}
