package sunbeam.precompute.patch;

import java.util.Arrays;

/**
 * The distinct heights of a patch and which of them each sample has. A scan of 8 bits has 256 levels, so that functions
 * of the height are evaluated 256 times instead of once per sample; a scan of floats may have as many levels as samples.
 *
 * @param levels distinct heights in metres, ascending
 * @param index for every sample, row by row, the index of its level
 */
public record HeightLevels(double[] levels, int[] index) {

    /**
     * Finds the distinct heights of a map.
     *
     * @throws IllegalArgumentException when a sample is missing: fill it first
     */
    public static HeightLevels of(HeightMap map) {
        double[] heights = map.toArray();
        for (int i = 0; i < heights.length; i++) {
            // -0 becomes 0: they are one height, but sorting and searching tell them apart.
            heights[i] += 0.0;
        }
        double[] sorted = heights.clone();
        Arrays.parallelSort(sorted);
        int count = 0;
        for (double height : sorted) {
            if (Double.isNaN(height)) {
                throw new IllegalArgumentException("missing samples must be filled first");
            }
            if (count == 0 || sorted[count - 1] != height) {
                sorted[count++] = height;
            }
        }
        double[] levels = Arrays.copyOf(sorted, count);
        return new HeightLevels(levels, index(heights, levels));
    }

    /**
     * The level of each height. Levels are looked for among those in the same of as many equal steps from the lowest to the
     * highest: a float scan of 4096 x 4096 has 16 million levels, through which a search alone would take a minute.
     */
    private static int[] index(double[] heights, double[] levels) {
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
        int[] index = new int[heights.length];
        Arrays.parallelSetAll(index, i -> {
            int from = step(heights[i], lowest, perMetre, levels.length);
            return Arrays.binarySearch(levels, first[from], first[from + 1], heights[i]);
        });
        return index;
    }

    /** Grows with the height, whatever the rounding: a height and its level are in the same step. */
    private static int step(double height, double lowest, double perMetre, int steps) {
        return (int) Math.min(steps, (height - lowest) * perMetre);
    }

    public int count() {
        return levels.length;
    }

    public double minimum() {
        return levels[0];
    }

    public double maximum() {
        return levels[levels.length - 1];
    }

    /** How many samples have each level. */
    public int[] histogram() {
        int[] counts = new int[levels.length];
        for (int i : index) {
            counts[i]++;
        }
        return counts;
    }
}
