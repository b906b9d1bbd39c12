package sunbeam.precompute.patch.builtin;

import java.util.Arrays;
import sunbeam.precompute.patch.builtin.FingerSkin.FingerShape;

/**
 * Positions of the fingers of a {@link FingerSkin}: a lattice with random deviations, fingers up (+y), rows counted downwards.
 *
 * @param rows number of rows in the patch, at least 3
 * @param fingers mean number of fingers in a row, at least 3
 * @param rowSpread standard deviation of the distance between rows, as a fraction of its mean
 * @param fingerSpread standard deviation of the distance between fingers of a row, as a fraction of its mean; deviations add up
 * @param coherenceRows rows (standard deviation) over which columns of fingers continue; 0: independent rows with random offsets
 * @param countSpread standard deviation of the number of fingers between independent rows
 * @param wander root mean square in meters of the common meander of the rows' lines
 * @param wanderModesX largest number of periods of the meander along x
 * @param wanderModesY largest number of periods of the meander along y; few keep neighboring rows parallel
 * @param tipSpread standard deviation in meters of single tips off their row's line
 * @param heightSpread standard deviation in meters of the height of single fingers
 * @param lean shift of a finger to +x per distance downwards, without unit
 */
record RowLayout(
        int rows,
        int fingers,
        double rowSpread,
        double fingerSpread,
        double coherenceRows,
        double countSpread,
        double wander,
        int wanderModesX,
        int wanderModesY,
        double tipSpread,
        double heightSpread,
        double lean) {
    // Equal slopes on all scales.
    private static final double WANDER_EXPONENT = 2;

    FingerRow[] place(FingerShape shape, double side, int places, SeededNoise noise) {
        double[] starts = intervalStarts(normals(rows, rowSpread, noise), side);
        int modesDown = Math.min(wanderModesY, (rows - 1) / 2);
        double[] meander = noise.powerLaw(places, rows, wander, WANDER_EXPONENT, wanderModesX, modesDown);
        double[][] centers = coherenceRows > 0 ? coherentCenters(side, noise) : independentCenters(side, noise);
        FingerRow[] placed = new FingerRow[rows];
        for (int row = 0; row < rows; row++) {
            double[] line = Arrays.copyOfRange(meander, row * places, (row + 1) * places);
            for (int i = 0; i < places; i++) {
                line[i] += starts[row];
            }
            double[] tips = normals(centers[row].length, tipSpread, noise);
            double[] lifts = normals(centers[row].length, heightSpread, noise);
            placed[row] = FingerRow.of(centers[row], tips, lifts, line, side, shape);
        }
        return placed;
    }

    private double[][] independentCenters(double side, SeededNoise noise) {
        double[][] centers = new double[rows][];
        for (int row = 0; row < centers.length; row++) {
            int count = (int) Math.max(3, Math.round(fingers + countSpread * noise.normal()));
            double offset = noise.uniform() * side;
            centers[row] = sortedWithin(intervalStarts(normals(count, fingerSpread, noise), side), offset, side);
        }
        return centers;
    }

    private double[][] coherentCenters(double side, SeededNoise noise) {
        double[][] deviations = new double[rows][];
        Arrays.setAll(deviations, row -> normals(fingers, fingerSpread, noise));
        double[][] smooth = smoothedOverRows(deviations, coherenceRows);
        double[][] centers = new double[rows][];
        for (int row = 0; row < centers.length; row++) {
            double[] regular = intervalStarts(smooth[row], side);
            double deviation = 0;
            for (int i = 0; i < regular.length; i++) {
                deviation += regular[i] - i * side / regular.length;
            }
            centers[row] = sortedWithin(regular, -deviation / regular.length, side);
        }
        return centers;
    }

    /** Intervals that fill the side, with lengths off their mean by the given fractions. */
    private static double[] intervalStarts(double[] deviations, double side) {
        double[] starts = new double[deviations.length];
        double sum = 0;
        for (int i = 0; i < starts.length; i++) {
            starts[i] = sum;
            // Shorter ones would merge two neighbors.
            sum += Math.max(0.4, 1 + deviations[i]);
        }
        double total = sum;
        return Arrays.stream(starts).map(start -> start * side / total).toArray();
    }

    private static double[] sortedWithin(double[] centers, double offset, double side) {
        return Arrays.stream(centers)
                .map(center -> (center + offset + side) % side)
                .sorted()
                .toArray();
    }

    private static double[] normals(int count, double deviation, SeededNoise noise) {
        double[] values = new double[count];
        Arrays.setAll(values, i -> deviation * noise.normal());
        return values;
    }

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

    /**
     * Row of fingers, tabulated over one period along x.
     *
     * @param line distance from the patch's top to the line through the tips, meters
     * @param phi 0 on the ridge of a finger, 1 midway to its neighbor
     * @param lift offset of the height, meters
     * @param edge see {@link FingerShape#edge}
     * @param edgeSlope absolute slope of the edge along x, per meter
     */
    record FingerRow(double[] line, double[] phi, double[] lift, double[] edge, double[] edgeSlope) {
        /** @param centers x of each ridge in meters, ascending within [0, side); tips and lifts are offsets in meters */
        static FingerRow of(
                double[] centers, double[] tips, double[] lifts, double[] rowLine, double side, FingerShape shape) {
            int size = rowLine.length;
            double[] line = new double[size];
            double[] phi = new double[size];
            double[] lift = new double[size];
            double[] edge = new double[size];
            int next = 0;
            for (int i = 0; i < size; i++) {
                double x = i * side / size;
                while (next < centers.length && centers[next] <= x) {
                    next++;
                }
                int left = Math.floorMod(next - 1, centers.length);
                int right = next % centers.length;
                double part = distance(centers[left], x, side) / distance(centers[left], centers[right], side);
                line[i] = rowLine[i] + (1 - part) * tips[left] + part * tips[right];
                lift[i] = (1 - part) * lifts[left] + part * lifts[right];
                phi[i] = part < 0.5 ? 2 * part : 2 - 2 * part;
                edge[i] = shape.edge(phi[i]);
            }
            return new FingerRow(line, phi, lift, edge, slope(edge, side));
        }

        static double at(double[] table, double place) {
            int left = (int) place;
            double part = place - left;
            int size = table.length;
            return (1 - part) * table[left % size] + part * table[(left + 1) % size];
        }

        private static double distance(double from, double to, double side) {
            return to < from ? to - from + side : to - from;
        }

        /** Returns the larger slope to either neighbor, so that none is 0 at a ridge or notch. */
        private static double[] slope(double[] values, double side) {
            int size = values.length;
            double[] slope = new double[size];
            for (int i = 0; i < size; i++) {
                double before = Math.abs(values[i] - values[Math.floorMod(i - 1, size)]);
                slope[i] = Math.max(Math.abs(values[(i + 1) % size] - values[i]), before) * size / side;
            }
            return slope;
        }
    }
}
