package sunbeam.precompute.patch.builtin;

/** One row of a {@link FingerSkin}, tabulated along x over one period. A {@code place} is a fractional index into the tables. */
final class FingerRow {
    private final double[] line;
    private final double[] phi;
    private final double[] lift;
    private final double[] edge;
    private final double[] edgeSlope;

    /**
     * @param centers x of each finger's ridge in meters, ascending within [0, side), at least two
     * @param tips distance of each tip below the row's line, meters
     * @param lifts random offset of the height of each finger, meters
     * @param line distance from the patch's top to the row's line, meters, one per table entry
     */
    FingerRow(double[] centers, double[] tips, double[] lifts, double[] line, double side, FingerShape shape) {
        int size = line.length;
        this.line = new double[size];
        phi = new double[size];
        lift = new double[size];
        edge = new double[size];
        int next = 0;
        for (int i = 0; i < size; i++) {
            double x = i * side / size;
            while (next < centers.length && centers[next] <= x) {
                next++;
            }
            int left = Math.floorMod(next - 1, centers.length);
            int right = next % centers.length;
            double part = distance(centers[left], x, side) / distance(centers[left], centers[right], side);
            this.line[i] = line[i] + (1 - part) * tips[left] + part * tips[right];
            lift[i] = (1 - part) * lifts[left] + part * lifts[right];
            phi[i] = part < 0.5 ? 2 * part : 2 - 2 * part;
            edge[i] = shape.edge(phi[i]);
        }
        edgeSlope = slope(edge, side);
    }

    /** Returns the distance from the patch's top to the line through the tips, meters. */
    double line(int place) {
        return line[place];
    }

    /** Returns phi: 0 on the ridge of a finger, 1 midway to its neighbor. */
    double phi(double place) {
        return at(phi, place);
    }

    double lift(double place) {
        return at(lift, place);
    }

    double edge(double place) {
        return at(edge, place);
    }

    /** Absolute slope of {@link #edge} along x, per meter. */
    double edgeSlope(double place) {
        return at(edgeSlope, place);
    }

    private static double at(double[] table, double place) {
        int left = (int) place;
        double part = place - left;
        int size = table.length;
        return (1 - part) * table[left % size] + part * table[(left + 1) % size];
    }

    private static double distance(double from, double to, double side) {
        return to < from ? to - from + side : to - from;
    }

    /** Returns at each entry the larger of the slopes to both neighbors, so that no slope is 0 at a ridge or notch. */
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
