package sunbeam.precompute.analysis;

import java.util.Arrays;
import sunbeam.precompute.optics.HeightMap;

/**
 * How much of the surface lies at which height.
 *
 * @param minimum lower edge of the first bin, metres
 * @param width of a bin, metres
 * @param shares of the samples in each bin; their sum is 1
 */
public record Histogram(double minimum, double width, double[] shares) {
    // Of a flat map, a picometre.
    private static final double FLAT_BIN = 1e-12;
    // More than these, and a bin holds so many that one more or less does not show.
    private static final int MOST_LEVELS = 5000;
    // Of the relief.
    private static final double ROUNDING = 1e-6;
    private static final int FIRST_LOOK = 1 << 16;

    /**
     * Counts a map's heights in at most so many equal bins from the lowest to the highest. A map with few distinct
     * heights, as 8-bit scans have, gets bins that each hold equally many of these: others would draw a comb.
     */
    public static Histogram of(HeightMap map, int mostBins) {
        double[] heights = map.toArray();
        double lowest = map.minimum();
        double relief = map.maximum() - lowest;
        if (relief == 0) {
            return new Histogram(lowest - 0.5 * FLAT_BIN, FLAT_BIN, new double[] {1});
        }
        double step = step(heights, lowest, relief);
        double intervals = relief / step;
        boolean quantised = intervals < MOST_LEVELS;
        double width = quantised ? step * Math.ceil((intervals + 1) / mostBins) : relief / mostBins;
        double minimum = quantised ? lowest - 0.5 * step : lowest;
        int bins = quantised ? (int) Math.ceil((relief + step) / width - 1e-6) : mostBins;
        long[] counts = new long[bins];
        for (double height : heights) {
            counts[Math.max(0, Math.min(bins - 1, (int) ((height - minimum) / width)))]++;
        }
        double[] shares = Arrays.stream(counts)
                .mapToDouble(count -> (double) count / heights.length)
                .toArray();
        return new Histogram(minimum, width, shares);
    }

    /** The smallest distance of two heights, beyond rounding; of some of them where these are too many levels already. */
    private static double step(double[] heights, double lowest, double relief) {
        double[] some = Arrays.copyOf(heights, Math.min(heights.length, FIRST_LOOK));
        Arrays.sort(some);
        double step = smallestDistance(some, relief);
        boolean many = relief / step >= MOST_LEVELS;
        if (some.length == heights.length || many || areMultiples(heights, lowest, step, ROUNDING * relief)) {
            return step;
        }
        double[] sorted = heights.clone();
        Arrays.parallelSort(sorted);
        return smallestDistance(sorted, relief);
    }

    /** Whether all heights are whole steps from the lowest, as those of an image with few levels. */
    private static boolean areMultiples(double[] heights, double lowest, double step, double rounding) {
        for (double height : heights) {
            double steps = (height - lowest) / step;
            if (!(Math.abs(steps - Math.rint(steps)) * step <= rounding)) {
                return false;
            }
        }
        return true;
    }

    private static double smallestDistance(double[] levels, double relief) {
        double rounding = ROUNDING * relief;
        double step = Double.POSITIVE_INFINITY;
        for (int i = 1; i < levels.length; i++) {
            double distance = levels[i] - levels[i - 1];
            step = distance > rounding ? Math.min(step, distance) : step;
        }
        return step;
    }

    public int bins() {
        return shares.length;
    }

    /** The height below which a share, 0..1, of the surface lies, to within a bin, metres. */
    public double quantile(double share) {
        double sum = 0;
        for (int bin = 0; bin < shares.length; bin++) {
            sum += shares[bin];
            if (sum >= share) {
                return centre(bin);
            }
        }
        return centre(shares.length - 1);
    }

    /** Height in the middle of a bin, metres. */
    public double centre(int bin) {
        return minimum + (bin + 0.5) * width;
    }
}
