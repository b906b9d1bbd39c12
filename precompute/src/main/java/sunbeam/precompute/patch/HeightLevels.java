package sunbeam.precompute.patch;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * The distinct heights of a patch and which of them each sample has. A scan of 8 bits has 256 levels, so that functions
 * of the height are evaluated 256 times instead of once per sample; a scan of floats may have as many levels as samples.
 * They are looked for when they are first asked for: plans need the lowest and the highest alone, and sorting 16 million
 * heights takes seconds. Immutable, safe for several threads.
 */
public final class HeightLevels {
    private static final int GLANCE = 8192;
    private static final double FEW_SAMPLES_PER_LEVEL = 4;

    private final HeightMap map;
    private final double minimum;
    private final double maximum;
    private Distinct distinct;
    private int[] index;

    /** Distinct heights, ascending, and how many samples have each. */
    private record Distinct(double[] levels, int[] counts) {
        /** @param sorted heights; overwritten */
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

    private HeightLevels(HeightMap map) {
        this.map = map;
        this.minimum = map.minimum() + 0.0;
        this.maximum = map.maximum() + 0.0;
    }

    /**
     * The levels of a map.
     *
     * @throws IllegalArgumentException when a sample is missing: fill it first
     */
    public static HeightLevels of(HeightMap map) {
        if (!map.isComplete()) {
            throw new IllegalArgumentException("missing samples must be filled first");
        }
        return new HeightLevels(map);
    }

    /** -0 becomes 0: they are one height, but sorting and searching tell them apart. */
    private double[] heights() {
        return map.map(height -> height + 0.0).heights();
    }

    private synchronized Distinct distinct() {
        if (distinct == null) {
            distinct = Distinct.of(heights());
        }
        return distinct;
    }

    /** The heights themselves. */
    public HeightMap map() {
        return map;
    }

    /** Distinct heights in meters, ascending; not to be written to. */
    public double[] levels() {
        return distinct().levels();
    }

    /** For every sample, row by row, the index of its level; not to be written to. */
    public synchronized int[] index() {
        if (index == null) {
            index = indexed();
        }
        return index;
    }

    /**
     * The level of each height. Levels are looked for among those in the same of as many equal steps from the lowest to the
     * highest: a float scan of 4096 x 4096 has 16 million levels, through which a search alone would take a minute.
     */
    private int[] indexed() {
        double[] levels = levels();
        double lowest = levels[0];
        double steps = levels.length / Math.max(levels[levels.length - 1] - lowest, Double.MIN_NORMAL);
        double perMetre = Double.isFinite(steps) ? steps : 0;
        int[] first = new int[levels.length + 2];
        int step = 0;
        for (int i = 0; i < levels.length; i++) {
            int reached = step(levels[i], lowest, perMetre, levels.length);
            while (step < reached) {
                first[++step] = i;
            }
        }
        Arrays.fill(first, step + 1, first.length, levels.length);
        int[] found = new int[map.heights().length];
        Arrays.parallelSetAll(found, i -> {
            double height = map.heights()[i] + 0.0;
            int from = step(height, lowest, perMetre, levels.length);
            return Arrays.binarySearch(levels, first[from], first[from + 1], height);
        });
        return found;
    }

    /** Grows with the height, whatever the rounding: a height and its level are in the same step. */
    private static int step(double height, double lowest, double perMetre, int steps) {
        return (int) Math.min(steps, (height - lowest) * perMetre);
    }

    public int count() {
        return levels().length;
    }

    public double minimum() {
        return minimum;
    }

    public double maximum() {
        return maximum;
    }

    /**
     * Whether so many heights differ, by a glance at some of them, that functions of the height are as soon evaluated at each
     * sample as at the levels, which would have to be looked for first.
     */
    public boolean areMany() {
        int samples = map.heights().length;
        int glance = Math.min(GLANCE, samples);
        double[] some = IntStream.range(0, glance)
                .mapToDouble(i -> map.heights()[(int) ((long) i * samples / glance)] + 0.0)
                .toArray();
        double distinct = Arrays.stream(some).distinct().count();
        // Of L levels n samples have n^2 / 2 L pairs of the same, where those are few (the birthday problem).
        double levels = distinct < 0.5 * glance ? distinct : 0.5 * glance * glance / (glance - distinct);
        return levels > samples / FEW_SAMPLES_PER_LEVEL;
    }

    /** How many samples have each level; not to be written to. */
    public int[] histogram() {
        return distinct().counts();
    }
}
