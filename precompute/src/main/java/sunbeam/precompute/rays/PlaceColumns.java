package sunbeam.precompute.rays;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorColumns;

/** Places at any w, one column each: colors are interpolated along w, by Lagrange's polynomial through the nearest of some slices, or all. */
final class PlaceColumns implements ColorColumns {
    /** Of many slices, those that a place between them is interpolated from. */
    static final int TAPS = 6;

    private static final int CHANNELS = 3;
    /** Of |w|. */
    private static final double DEEPEST = 2;
    // Of what changes fastest along w, from slice to slice where four suffice (TableDesign).
    private static final double PERIODS_PER_STEP = 0.06;
    // That slices may leave of it.
    private static final double ERROR = 5e-5;

    private final float[] places;
    private final double[] depths;
    private final int taps;
    // Of the taps' weights; those of all slices, or of some that are equally far apart.
    private final double[] denominators;
    private final double[] xyz;

    /** @param taps slices that each place is interpolated from: one of its own, some that are equally far apart, or all */
    private PlaceColumns(float[] places, double[] depths, int taps) {
        this.places = places;
        this.depths = depths;
        this.taps = taps;
        this.denominators = IntStream.range(0, taps)
                .mapToDouble(slice -> IntStream.range(0, taps)
                        .filter(other -> other != slice)
                        .mapToDouble(other -> depths[slice] - depths[other])
                        .reduce(1, (product, factor) -> product * factor))
                .toArray();
        this.xyz = new double[places.length];
    }

    /**
     * As few slices as suffice: at each of few different w; between the lowest and the deepest of the places as Chebyshev's polynomials have
     * zeros; or, where these were many, at equal distances.
     *
     * @param places u, v, w of each place
     * @param widestStep of |w| between slices at equal distances of which four suffice
     */
    static PlaceColumns of(float[] places, double widestStep) {
        double[] all = IntStream.range(0, places.length / CHANNELS)
                .mapToDouble(place -> Math.abs(places[CHANNELS * place + 2]))
                .toArray();
        double lowest = Arrays.stream(all).min().orElse(0);
        double range = Arrays.stream(all).max().orElse(0) - lowest;
        int zeros = zeros(Math.PI * PERIODS_PER_STEP * range / widestStep);
        double[] different =
                DoubleStream.of(all).distinct().limit(2L * zeros + 1).toArray();
        if (different.length <= 2 * zeros) {
            return new PlaceColumns(places, DoubleStream.of(different).sorted().toArray(), 1);
        }
        return zeros > 2 * TAPS
                ? spaced(places, lowest, range, widestStep)
                : new PlaceColumns(
                        places,
                        IntStream.range(0, zeros)
                                .mapToDouble(i -> lowest + 0.5 * range * (1 - Math.cos(Math.PI * (i + 0.5) / zeros)))
                                .toArray(),
                        zeros);
    }

    /**
     * Zeros of Chebyshev's polynomial through which a wave is interpolated: that errs by 2 (phase / 2)^n / n!, where its derivatives are 1.
     *
     * @param phase of the wave from the middle to an end
     */
    private static int zeros(double phase) {
        int zeros = 1;
        double error = phase;
        while (zeros < 2 || (error > ERROR && zeros <= 2 * TAPS)) {
            zeros++;
            error *= phase / (2 * zeros);
        }
        return zeros;
    }

    /** The same slices whatever places there are, so that no place's color depends on others. */
    static PlaceColumns throughAll(float[] places, double widestStep) {
        return spaced(places, 0, DEEPEST, widestStep);
    }

    private static PlaceColumns spaced(float[] places, double lowest, double range, double widestStep) {
        int slices = Math.max(TAPS, 1 + (int) Math.ceil(range / widestStep));
        double step = range / (slices - 1);
        double[] depths =
                IntStream.range(0, slices).mapToDouble(i -> lowest + i * step).toArray();
        return new PlaceColumns(places, depths, TAPS);
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
        int first = firstTap(column);
        for (int tap = 0; tap < taps; tap++) {
            slices[tap] = first + tap;
        }
        return taps;
    }

    private int firstTap(int column) {
        if (taps == depths.length) {
            return 0;
        }
        if (taps == 1) {
            return Arrays.binarySearch(depths, depth(column));
        }
        int below = (int) ((depth(column) - depths[0]) / (depths[1] - depths[0]));
        return Math.max(0, Math.min(below - taps / 2 + 1, depths.length - taps));
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        int first = firstTap(column);
        double depth = depth(column);
        double weight = 1 / denominators[slice - first];
        for (int other = first; other < first + taps; other++) {
            weight *= other == slice ? 1 : depth - depths[other];
        }
        int at = CHANNELS * column;
        xyz[at] += weight * x * x;
        xyz[at + 1] += weight * y * y;
        xyz[at + 2] += weight * z * z;
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
