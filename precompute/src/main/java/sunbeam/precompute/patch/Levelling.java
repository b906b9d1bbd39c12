package sunbeam.precompute.patch;

import java.util.Locale;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * What is subtracted from measured heights before anything else: a scan sits micrometres, at times millimetres, above
 * zero and is tilted against the microscope. Missing samples (NaN, infinities) take no part and stay missing.
 */
public enum Levelling {
    /** Heights as they are. */
    NONE,
    /** The mean height is subtracted. */
    MEAN,
    /** The least-squares plane a + b x + c y is subtracted. */
    PLANE;

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The levelled height map, on the same grid. */
    public HeightMap apply(HeightMap map) {
        if (this == NONE) {
            return map;
        }
        double[] heights = map.toArray();
        subtractMean(heights);
        if (this == PLANE) {
            subtractSlope(heights, map.columns(), map.rows());
        }
        // What rounding left of the mean: the first sum runs over values that may be large against their differences.
        subtractMean(heights);
        return map.withOwned(heights);
    }

    private static void subtractMean(double[] heights) {
        double sum = 0;
        long count = 0;
        for (double height : heights) {
            if (Double.isFinite(height)) {
                sum += height;
                count++;
            }
        }
        double mean = count == 0 ? 0 : sum / count;
        for (int i = 0; i < heights.length; i++) {
            heights[i] -= mean;
        }
    }

    /**
     * Subtracts the slope of the least-squares plane from heights of mean zero. Coordinates run from -1 to 1 and are
     * centred on the samples that count, so the 2 x 2 normal equations are as well conditioned as the samples allow;
     * where these lie on one line, the pseudo-inverse takes the slope along it.
     */
    private static void subtractSlope(double[] heights, int columns, int rows) {
        double[] centre = centroid(heights, columns, rows);
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xh = 0;
        double yh = 0;
        for (int i = 0; i < heights.length; i++) {
            if (Double.isFinite(heights[i])) {
                double x = coordinate(i % columns, columns) - centre[0];
                double y = coordinate(i / columns, rows) - centre[1];
                xx += x * x;
                xy += x * y;
                yy += y * y;
                xh += x * heights[i];
                yh += y * heights[i];
            }
        }
        RealVector slope = new SingularValueDecomposition(new Array2DRowRealMatrix(new double[][] {{xx, xy}, {xy, yy}}))
                .getSolver()
                .solve(new ArrayRealVector(new double[] {xh, yh}));
        for (int i = 0; i < heights.length; i++) {
            double x = coordinate(i % columns, columns) - centre[0];
            double y = coordinate(i / columns, rows) - centre[1];
            heights[i] -= slope.getEntry(0) * x + slope.getEntry(1) * y;
        }
    }

    private static double[] centroid(double[] heights, int columns, int rows) {
        double x = 0;
        double y = 0;
        long count = 0;
        for (int i = 0; i < heights.length; i++) {
            if (Double.isFinite(heights[i])) {
                x += coordinate(i % columns, columns);
                y += coordinate(i / columns, rows);
                count++;
            }
        }
        return count == 0 ? new double[] {0, 0} : new double[] {x / count, y / count};
    }

    /** Index to [-1, 1]; 0 where there is only one. */
    private static double coordinate(int index, int count) {
        return count == 1 ? 0 : 2.0 * index / (count - 1) - 1;
    }
}
