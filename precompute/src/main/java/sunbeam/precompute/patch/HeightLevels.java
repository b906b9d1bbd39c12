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
        double[] sorted = heights.clone();
        Arrays.sort(sorted);
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
        int[] index = new int[heights.length];
        Arrays.parallelSetAll(index, i -> Arrays.binarySearch(levels, heights[i] + 0.0));
        return new HeightLevels(levels, index);
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
