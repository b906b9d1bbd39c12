package sunbeam.precompute.analysis;

import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.SlopeCheck;

/**
 * Heights and slopes of a patch in numbers.
 *
 * @param relief highest minus lowest height, metres
 * @param rms root mean square of the heights about their mean (the roughness Sq of ISO 25178), metres
 * @param largestSlope tangent of the steepest angle
 * @param rmsSlope root mean square of the tangents (Sdq of ISO 25178)
 * @param steepShare share of the surface, 0..1, that is steeper than {@link #STEEP_DEGREES}
 */
public record HeightStatistics(double relief, double rms, double largestSlope, double rmsSlope, double steepShare) {

    /**
     * Above this angle the scalar theory's picture fails: light meets a facet more than once, and one height per
     * position, lit from above, no longer tells its path.
     */
    public static final double STEEP_DEGREES = SlopeCheck.STEEPEST;

    /** Measures a map without missing samples. */
    public static HeightStatistics of(HeightMap map) {
        double[] slopes = squaredSlopes(map);
        double steep = Math.pow(Math.tan(Math.toRadians(STEEP_DEGREES)), 2);
        double sum = 0;
        double largest = 0;
        int steeper = 0;
        for (double slope : slopes) {
            sum += slope;
            largest = Math.max(largest, slope);
            // 1e-9: a slope of exactly so many degrees is not steeper for its rounding.
            steeper += slope > steep * (1 + 1e-9) ? 1 : 0;
        }
        return new HeightStatistics(
                map.relief(),
                rms(map.toArray()),
                Math.sqrt(largest),
                Math.sqrt(sum / slopes.length),
                (double) steeper / slopes.length);
    }

    /** Root mean square about the mean. */
    static double rms(double[] heights) {
        double mean = 0;
        for (int i = 0; i < heights.length; i++) {
            mean += (heights[i] - mean) / (i + 1);
        }
        double sum = 0;
        for (double height : heights) {
            sum += (height - mean) * (height - mean);
        }
        return Math.sqrt(sum / heights.length);
    }

    /** |gradient|^2 between neighbours inside the patch: its seam is no slope of the surface. */
    private static double[] squaredSlopes(HeightMap map) {
        int columns = Math.max(1, map.columns() - 1);
        int rows = Math.max(1, map.rows() - 1);
        double[] slopes = new double[Math.multiplyExact(columns, rows)];
        for (int row = 0, i = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++, i++) {
                double along = map.columns() == 1 ? 0 : (map.at(column + 1, row) - map.at(column, row)) / map.pitchX();
                double down = map.rows() == 1 ? 0 : (map.at(column, row + 1) - map.at(column, row)) / map.pitchY();
                slopes[i] = along * along + down * down;
            }
        }
        return slopes;
    }
}
