package sunbeam.precompute.rays;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorColumns;

/** Places one after the other, as columns; those that follow each other with one (u, v) are one column. */
final class PlaceColumns implements ColorColumns {
    private static final int CHANNELS = 3;
    private static final int MOST_SLICES = 2048;

    private final float[] places;
    private final double[] depths;
    // The first place of each column, and behind the last one the number of all.
    private final int[] first;
    private final float[] xyz;

    /**
     * Nothing is known yet.
     *
     * @param places u, v, w of each place
     * @throws IllegalArgumentException if they have more different w than slices are meant
     */
    PlaceColumns(float[] places) {
        this.places = places;
        this.xyz = new float[places.length];
        int count = places.length / CHANNELS;
        this.depths = IntStream.range(0, count)
                .mapToDouble(this::depth)
                .sorted()
                .distinct()
                .toArray();
        if (depths.length > MOST_SLICES) {
            throw new IllegalArgumentException("places lie in more than " + MOST_SLICES + " slices of w");
        }
        this.first = IntStream.rangeClosed(0, count)
                .filter(i -> i == 0 || i == count || !isBesideLast(i))
                .toArray();
    }

    private double depth(int place) {
        return Math.abs(places[CHANNELS * place + 2]);
    }

    private boolean isBesideLast(int place) {
        int at = CHANNELS * place;
        return places[at] == places[at - CHANNELS] && places[at + 1] == places[at + 1 - CHANNELS];
    }

    @Override
    public int count() {
        return first.length - 1;
    }

    @Override
    public void locate(int column, float[] uv) {
        System.arraycopy(places, CHANNELS * first[column], uv, 0, 2);
    }

    @Override
    public double[] depths() {
        return depths.clone();
    }

    @Override
    public int asked(int column, int[] slices) {
        int[] asked = IntStream.range(first[column], first[column + 1])
                .map(place -> Arrays.binarySearch(depths, depth(place)))
                .sorted()
                .distinct()
                .toArray();
        System.arraycopy(asked, 0, slices, 0, asked.length);
        return asked.length;
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        for (int place = first[column]; place < first[column + 1]; place++) {
            if (depth(place) == depths[slice]) {
                xyz[CHANNELS * place] = (float) (x * x);
                xyz[CHANNELS * place + 1] = (float) (y * y);
                xyz[CHANNELS * place + 2] = (float) (z * z);
            }
        }
    }

    /** X, Y, Z of each place, once they have been put. */
    float[] xyz() {
        return Arrays.copyOf(xyz, xyz.length);
    }
}
