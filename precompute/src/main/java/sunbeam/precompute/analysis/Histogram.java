package sunbeam.precompute.analysis;

import sunbeam.precompute.optics.HeightMap;

/**
 * How much of the surface lies at which height.
 *
 * @param centers heights in even steps, metres
 * @param shares of the samples near each; their sum is 1
 */
public record Histogram(double[] centers, double[] shares) {

    /**
     * Counts a map's heights. Each is shared out between the two centers beside it, so that few distinct heights, as
     * 8-bit scans have, draw no comb.
     *
     * @param bins from the lowest to the highest height; one where all are the same
     */
    public static Histogram of(HeightMap map, int bins) {
        double lowest = map.minimum();
        if (map.relief() == 0) {
            return new Histogram(new double[] {lowest}, new double[] {1});
        }
        double width = map.relief() / (bins - 1);
        double[] centers = new double[bins];
        double[] shares = new double[bins];
        for (int bin = 0; bin < bins; bin++) {
            centers[bin] = lowest + bin * width;
        }
        double[] heights = map.toArray();
        for (double height : heights) {
            double place = (height - lowest) / width;
            int bin = Math.min(bins - 2, (int) place);
            shares[bin] += (1 - (place - bin)) / heights.length;
            shares[bin + 1] += (place - bin) / heights.length;
        }
        return new Histogram(centers, shares);
    }
}
