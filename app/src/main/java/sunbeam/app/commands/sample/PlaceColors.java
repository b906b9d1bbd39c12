package sunbeam.app.commands.sample;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorColumns;
import sunbeam.precompute.colortable.TableDesign;

/**
 * X, Y, Z at places: interpolated along w by Lagrange's polynomial through six slices, which are the same whatever places there
 * are, so that no place's color depends on others.
 */
final class PlaceColors implements ColorColumns {
    private static final int CHANNELS = 3;
    private static final int TAPS = 6;
    private static final double DEEPEST = 2;

    private final float[] places;
    private final float[] xyz;
    private final double[] depths;
    private final double step;

    /**
     * Nothing is known yet.
     *
     * @param places u, v, w of each
     */
    PlaceColors(float[] places, TableDesign design) {
        this.places = places;
        this.xyz = new float[places.length];
        int slices = Math.max(TAPS, 1 + (int) Math.ceil(DEEPEST / design.sliceStep()));
        this.step = DEEPEST / (slices - 1);
        this.depths = IntStream.range(0, slices).mapToDouble(i -> i * step).toArray();
    }

    /** Slices that each place asks for. */
    static int slicesOfPlace() {
        return TAPS;
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

    private double slice(int column) {
        return Math.abs(places[CHANNELS * column + 2]) / step;
    }

    private int firstTap(double slice) {
        return Math.max(0, Math.min((int) slice - TAPS / 2 + 1, depths.length - TAPS));
    }

    @Override
    public int asked(int column, int[] slices) {
        int first = firstTap(slice(column));
        Arrays.setAll(slices, tap -> first + tap);
        return TAPS;
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        double at = slice(column);
        int first = firstTap(at);
        double weight = 1;
        for (int other = first; other < first + TAPS; other++) {
            weight *= other == slice ? 1 : (at - other) / (slice - other);
        }
        xyz[CHANNELS * column] += (float) (weight * x * x);
        xyz[CHANNELS * column + 1] += (float) (weight * y * y);
        xyz[CHANNELS * column + 2] += (float) (weight * z * z);
    }

    /** X, Y, Z of each place, once all roots have been put; between dark slices a little below nothing is nothing. */
    float[] xyz() {
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = Math.max(0, xyz[i]);
        }
        return xyz;
    }
}
