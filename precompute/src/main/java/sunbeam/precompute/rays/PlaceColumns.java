package sunbeam.precompute.rays;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorColumns;

/**
 * Places at any w, one column each: colors are interpolated along w, by Lagrange's polynomial through the nearest of some equally spaced
 * slices.
 */
final class PlaceColumns implements ColorColumns {
    /** Slices that a place between them is interpolated from. */
    static final int TAPS = 6;

    private static final int CHANNELS = 3;
    /** Of |w|. */
    private static final double DEEPEST = 2;

    private final float[] places;
    private final double[] depths;
    private final boolean isSlices;
    private final double step;
    private final double[] xyz;

    private PlaceColumns(float[] places, double[] depths, boolean isSlices, double step) {
        this.places = places;
        this.depths = depths;
        this.isSlices = isSlices;
        this.step = step;
        this.xyz = new double[places.length];
    }

    /**
     * Slices from the lowest to the deepest of the places, or at each of few different w.
     *
     * @param places u, v, w of each place
     * @param widestStep of |w| between slices
     */
    static PlaceColumns of(float[] places, double widestStep) {
        double[] all = IntStream.range(0, places.length / CHANNELS)
                .mapToDouble(place -> Math.abs(places[CHANNELS * place + 2]))
                .toArray();
        double lowest = Arrays.stream(all).min().orElse(0);
        double range = Arrays.stream(all).max().orElse(0) - lowest;
        int slices = slices(range, widestStep);
        double[] different =
                Arrays.stream(all).distinct().limit(2L * slices + 1).sorted().toArray();
        return different.length <= 2 * slices
                ? new PlaceColumns(places, different, true, 0)
                : spaced(places, lowest, range, slices);
    }

    /** The same slices whatever places there are, so that no place's color depends on others. */
    static PlaceColumns throughAll(float[] places, double widestStep) {
        return spaced(places, 0, DEEPEST, slices(DEEPEST, widestStep));
    }

    private static int slices(double range, double widestStep) {
        return Math.max(TAPS, 1 + (int) Math.ceil(range / widestStep));
    }

    private static PlaceColumns spaced(float[] places, double lowest, double range, int slices) {
        double step = range / (slices - 1);
        double[] depths =
                IntStream.range(0, slices).mapToDouble(i -> lowest + i * step).toArray();
        return new PlaceColumns(places, depths, false, step);
    }

    private double depth(int place) {
        return Math.abs(places[CHANNELS * place + 2]);
    }

    @Override
    public int count() {
        return places.length / CHANNELS;
    }

    @Override
    public void locate(int column, float[] uv) {
        System.arraycopy(places, CHANNELS * column, uv, 0, 2);
    }

    @Override
    public double[] depths() {
        return depths.clone();
    }

    @Override
    public int asked(int column, int[] slices) {
        if (isSlices) {
            slices[0] = Arrays.binarySearch(depths, depth(column));
            return 1;
        }
        int first = firstTap(column);
        for (int tap = 0; tap < TAPS; tap++) {
            slices[tap] = first + tap;
        }
        return TAPS;
    }

    private int firstTap(int column) {
        int below = (int) ((depth(column) - depths[0]) / step);
        return Math.max(0, Math.min(below - TAPS / 2 + 1, depths.length - TAPS));
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        double weight = isSlices ? 1 : weight(column, slice);
        int at = CHANNELS * column;
        xyz[at] += weight * x * x;
        xyz[at + 1] += weight * y * y;
        xyz[at + 2] += weight * z * z;
    }

    private double weight(int column, int slice) {
        double at = (depth(column) - depths[0]) / step;
        int first = firstTap(column);
        double weight = 1;
        for (int other = first; other < first + TAPS; other++) {
            weight *= other == slice ? 1 : (at - other) / (slice - other);
        }
        return weight;
    }

    /** Slices that each place is interpolated from. */
    int slicesOfPlace() {
        return isSlices ? 1 : TAPS;
    }

    /** X, Y, Z of each place, once all roots have been put; between dark slices a little below nothing is nothing. */
    float[] xyz() {
        float[] rounded = new float[xyz.length];
        for (int i = 0; i < xyz.length; i++) {
            rounded[i] = (float) Math.max(0, xyz[i]);
        }
        return rounded;
    }
}
