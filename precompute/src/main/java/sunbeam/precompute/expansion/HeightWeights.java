package sunbeam.precompute.expansion;

import java.util.Arrays;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

/**
 * The heights of a patch by a few that stand for all.
 *
 * @param heights scaled, in -1..1
 * @param shares of the surface that each stands for; all together 1
 */
record HeightWeights(double[] heights, double[] shares) {

    /** The lowest, the mean and the highest of each bin of a histogram that is not empty. */
    static HeightWeights of(HeightLevels levels, HeightScale scale, int bins) {
        HeightMap map = levels.map();
        double[] share = new double[bins];
        double[] lowest = new double[bins];
        double[] highest = new double[bins];
        double[] sum = new double[bins];
        Arrays.fill(lowest, Double.MAX_VALUE);
        Arrays.fill(highest, -Double.MAX_VALUE);
        double samples = (double) map.columns() * map.rows();
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                double height = scale.scaled(map.at(column, row));
                int bin = (int) Math.min(bins - 1.0, Math.max(0, Math.floor((height + 1) / 2 * bins)));
                share[bin]++;
                sum[bin] += height;
                lowest[bin] = Math.min(lowest[bin], height);
                highest[bin] = Math.max(highest[bin], height);
            }
        }
        double[] heights = new double[3 * bins];
        double[] shares = new double[3 * bins];
        int used = 0;
        for (int bin = 0; bin < bins; bin++) {
            if (share[bin] > 0) {
                double[] three = {lowest[bin], sum[bin] / share[bin], highest[bin]};
                int distinct = lowest[bin] == highest[bin] ? 1 : 3;
                for (int i = 0; i < distinct; i++) {
                    heights[used] = three[i];
                    shares[used++] = share[bin] / samples / distinct;
                }
            }
        }
        return new HeightWeights(Arrays.copyOf(heights, used), Arrays.copyOf(shares, used));
    }
}
