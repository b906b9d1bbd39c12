package sunbeam.precompute.analysis;

import sunbeam.precompute.patch.HeightMap;

/**
 * How much of the surface lies at which height.
 *
 * @param minimum lower edge of the first bin, metres
 * @param width of a bin, metres
 * @param shares of the samples in each bin; their sum is 1
 */
public record Histogram(double minimum, double width, double[] shares) {

    /** Counts a map's heights in equal bins from the lowest to the highest; a flat map has all in the middle one. */
    public static Histogram of(HeightMap map, int bins) {
        double[] heights = map.toArray();
        // A flat map gets bins of a picometre around its height.
        double span = Math.max(map.relief(), bins * 1e-12);
        double minimum = 0.5 * (map.minimum() + map.maximum() - span);
        double[] shares = new double[bins];
        for (double height : heights) {
            int bin = (int) ((height - minimum) / span * bins);
            shares[Math.max(0, Math.min(bins - 1, bin))] += 1.0 / heights.length;
        }
        return new Histogram(minimum, span / bins, shares);
    }

    /** Height in the middle of a bin, metres. */
    public double centre(int bin) {
        return minimum + (bin + 0.5) * width;
    }
}
