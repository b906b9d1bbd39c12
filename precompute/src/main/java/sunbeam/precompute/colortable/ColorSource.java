package sunbeam.precompute.colortable;

import java.util.Arrays;

/** Colors of diffracted power at any (u, v, w), many at a time. Belongs to the thread that made it. */
@FunctionalInterface
public interface ColorSource extends AutoCloseable {
    /** Places that are handed over at once: 50 MB each way. */
    int BATCH = 1 << 22;

    /**
     * CIE X, Y, Z of power, 3 values a place, in the order of the places.
     *
     * @param places u, v, w of each place; w at most 0
     */
    float[] xyz(float[] places);

    /** As {@link #xyz}, each place by itself: for few, that what is interpolated between many is validated with. */
    default float[] exact(float[] places) {
        return xyz(places);
    }

    /** As {@link #xyz}, all slices of a column one after the other. */
    default void evaluate(ColorColumns columns) {
        double[] depths = columns.depths();
        float[] places = new float[0];
        int[] numbers = new int[0];
        int count = 0;
        float[] uv = new float[2];
        int[] slices = new int[depths.length];
        for (int column = 0; column < columns.count(); column++) {
            columns.locate(column, uv);
            int asked = columns.asked(column, slices);
            for (int i = 0; i < asked; i++) {
                if (2 * count == numbers.length) {
                    numbers = Arrays.copyOf(numbers, Math.max(1 << 10, 2 * numbers.length));
                    places = Arrays.copyOf(places, 3 * numbers.length / 2);
                }
                places[3 * count] = uv[0];
                places[3 * count + 1] = uv[1];
                places[3 * count + 2] = (float) -depths[slices[i]];
                numbers[2 * count] = column;
                numbers[2 * count + 1] = slices[i];
                if (++count == BATCH) {
                    put(xyz(Arrays.copyOf(places, 3 * count)), numbers, columns);
                    count = 0;
                }
            }
        }
        if (count > 0) {
            put(xyz(Arrays.copyOf(places, 3 * count)), numbers, columns);
        }
    }

    /** @param numbers column and slice of each place */
    private static void put(float[] xyz, int[] numbers, ColorColumns columns) {
        for (int i = 0; i < xyz.length / 3; i++) {
            columns.put(numbers[2 * i], numbers[2 * i + 1], xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
        }
    }

    @Override
    default void close() {}
}
