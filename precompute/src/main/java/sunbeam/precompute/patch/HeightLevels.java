package sunbeam.precompute.patch;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * Distinct heights of a patch, found on first use because sorting 16 million takes seconds, and the index of each sample among them:
 * functions of the height need one value per level, 256 for a scan of 8 bits. Immutable, thread-safe.
 */
public final class HeightLevels {
    private static final int EXAMINED_SAMPLES = 8192;
    // With fewer, finding the levels costs more time than it saves.
    private static final double FEW_SAMPLES_PER_LEVEL = 4;

    private final HeightMap map;

    private Distinct distinct;
    private int[] index;

    private record Distinct(double[] levels, int[] counts) {
        static Distinct of(double[] sorted) {
            Arrays.parallelSort(sorted);
            int[] counts = new int[sorted.length];
            int count = 0;
            for (double height : sorted) {
                if (count == 0 || sorted[count - 1] != height) {
                    sorted[count++] = height;
                }
                counts[count - 1]++;
            }
            return count == sorted.length
                    ? new Distinct(sorted, counts)
                    : new Distinct(Arrays.copyOf(sorted, count), Arrays.copyOf(counts, count));
        }
    }

    /** Throws IllegalArgumentException if a sample is missing. */
    public HeightLevels(HeightMap map) {
        if (!map.isComplete()) {
            throw new IllegalArgumentException("missing samples must be filled first");
        }
        this.map = map;
    }

    private synchronized Distinct distinct() {
        if (distinct == null) {
            // Replaces -0 by 0; sorting and searching distinguish them.
            distinct = Distinct.of(map.map(height -> height + 0.0).heights());
        }
        return distinct;
    }

    public HeightMap map() {
        return map;
    }

    /** Returns the distinct heights in meters, ascending; read-only. */
    public double[] levels() {
        return distinct().levels();
    }

    /** Returns the index of each sample's level, row by row; read-only. */
    public synchronized int[] index() {
        if (index == null) {
            index = indexed();
        }
        return index;
    }

    /** Searches in {@code count()} equal intervals; a search among all levels of 4096 x 4096 samples would take a minute. */
    private int[] indexed() {
        double[] levels = levels();
        double lowest = levels[0];
        double steps = levels.length / Math.max(levels[levels.length - 1] - lowest, Double.MIN_NORMAL);
        double perMeter = Double.isFinite(steps) ? steps : 0;
        int[] first = new int[levels.length + 2];
        int step = 0;
        for (int i = 0; i < levels.length; i++) {
            int reached = step(levels[i], lowest, perMeter, levels.length);
            while (step < reached) {
                first[++step] = i;
            }
        }
        Arrays.fill(first, step + 1, first.length, levels.length);
        int[] found = new int[map.heights().length];
        Arrays.parallelSetAll(found, i -> {
            double height = map.heights()[i] + 0.0;
            int from = step(height, lowest, perMeter, levels.length);
            return Arrays.binarySearch(levels, first[from], first[from + 1], height);
        });
        return found;
    }

    /** Monotonic in spite of rounding; a height and its equal level get the same interval. */
    private static int step(double height, double lowest, double perMeter, int steps) {
        return (int) Math.min(steps, (height - lowest) * perMeter);
    }

    public int count() {
        return levels().length;
    }

    public double minimum() {
        return map.minimum() + 0.0;
    }

    public double maximum() {
        return map.maximum() + 0.0;
    }

    /** Estimates from some samples whether evaluating a function for all is faster than finding the levels. */
    public boolean areTooManyToTabulate() {
        int samples = map.heights().length;
        int examined = Math.min(EXAMINED_SAMPLES, samples);
        double[] some = IntStream.range(0, examined)
                .mapToDouble(i -> map.heights()[(int) ((long) i * samples / examined)] + 0.0)
                .toArray();
        double distinct = Arrays.stream(some).distinct().count();
        // With L levels, n samples have n^2 / (2 L) equal pairs if these are few (birthday problem).
        double levels = distinct < 0.5 * examined ? distinct : 0.5 * examined * examined / (examined - distinct);
        return levels > samples / FEW_SAMPLES_PER_LEVEL;
    }

    public int[] histogram() {
        return distinct().counts();
    }
}
