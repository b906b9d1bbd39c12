package sunbeam.precompute.analysis;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError;

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
    public static final double STEEP_DEGREES = ModelError.STEEPEST;

    /** Measures a map without missing samples. */
    public static HeightStatistics of(HeightMap map) {
        int columns = Math.max(1, map.columns() - 1);
        int rows = Math.max(1, map.rows() - 1);
        List<Slopes> each = IntStream.range(0, rows)
                .parallel()
                .mapToObj(row -> Slopes.of(map, row, columns))
                .toList();
        double count = (double) columns * rows;
        return new HeightStatistics(
                map.relief(),
                rms(map.toArray()),
                Math.sqrt(each.stream().mapToDouble(Slopes::largest).max().orElseThrow()),
                Math.sqrt(each.stream().mapToDouble(Slopes::sum).sum() / count),
                each.stream().mapToInt(Slopes::steeper).sum() / count);
    }

    /** Root mean square about the mean. */
    static double rms(double[] heights) {
        // Relative to one of them, so that a large common offset costs no digits.
        double offset = 0;
        for (double height : heights) {
            offset += height - heights[0];
        }
        double mean = heights[0] + offset / heights.length;
        double sum = 0;
        for (double height : heights) {
            sum += (height - mean) * (height - mean);
        }
        return Math.sqrt(sum / heights.length);
    }

    /** |gradient|^2 between the neighbors of a row and the next, inside the patch: its seam is no slope of the surface. */
    private record Slopes(double sum, double largest, int steeper) {
        static Slopes of(HeightMap map, int row, int columns) {
            double steep = Math.pow(Math.tan(Math.toRadians(STEEP_DEGREES)), 2);
            double sum = 0;
            double largest = 0;
            int steeper = 0;
            for (int column = 0; column < columns; column++) {
                double along = map.columns() == 1 ? 0 : (map.at(column + 1, row) - map.at(column, row)) / map.pitchX();
                double down = map.rows() == 1 ? 0 : (map.at(column, row + 1) - map.at(column, row)) / map.pitchY();
                double slope = along * along + down * down;
                sum += slope;
                largest = Math.max(largest, slope);
                // 1e-9: a slope of exactly so many degrees is not steeper for its rounding.
                steeper += slope > steep * (1 + 1e-9) ? 1 : 0;
            }
            return new Slopes(sum, largest, steeper);
        }
    }
}
