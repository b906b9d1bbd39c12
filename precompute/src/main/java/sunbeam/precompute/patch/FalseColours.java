package sunbeam.precompute.patch;

import java.util.HashMap;
import java.util.Map;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;

/**
 * Whether a coloured image is a picture of heights in false colours, none of whose channels is a height. A colour map
 * draws a curve through the space of red, green and blue. Three channels that are proportional draw a straight line,
 * and each of them is as good as the heights; channels that have nothing to do with each other fill an area.
 */
final class FalseColours {
    /** Fewer pixels say too little. */
    private static final int FEWEST_PIXELS = 1024;

    private static final int MOST_PIXELS = 1 << 18;
    /** Share of the variance off the straight line; compressed or rounded greys have half of it at most. */
    private static final double MOST_OFF_LINE = 0.002;
    /**
     * Variance across over variance along a piece of the line; 0 for a map as drawn, 0.2 after scaling and smoothing, and 1 for
     * channels that know nothing of each other.
     */
    private static final double MOST_ACROSS = 0.35;

    /** Pieces of the colour space, along a side. */
    private static final int CELLS = 8;

    private static final int FEWEST_IN_CELL = 16;

    private FalseColours() {}

    /** Sums over some colours. */
    private static final class Moments {
        private final double[] sum = new double[3];
        private final double[][] products = new double[3][3];
        private int count;

        private void add(double[] colour) {
            count++;
            for (int i = 0; i < 3; i++) {
                sum[i] += colour[i];
                for (int j = 0; j < 3; j++) {
                    products[i][j] += colour[i] * colour[j];
                }
            }
        }

        /** Times the count: variance along the principal axis, and across it. */
        private double[] alongAndAcross() {
            double[][] covariance = new double[3][3];
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    covariance[i][j] = products[i][j] - sum[i] * sum[j] / count;
                }
            }
            double[] values = new EigenDecomposition(new Array2DRowRealMatrix(covariance)).getRealEigenvalues();
            double along = Math.max(values[0], Math.max(values[1], values[2]));
            return new double[] {along, values[0] + values[1] + values[2] - along};
        }
    }

    /** Looks at a quarter of a million pixels at most. */
    static boolean in(ImageBands bands) {
        long pixels = (long) bands.columns() * bands.rows();
        if (pixels < FEWEST_PIXELS) {
            return false;
        }
        int step = (int) Math.max(1, Math.round(Math.sqrt((double) pixels / MOST_PIXELS)));
        Moments all = new Moments();
        Map<Integer, Moments> cells = new HashMap<>();
        double[][] rows = new double[3][bands.columns()];
        for (int row = 0; row < bands.rows(); row += step) {
            for (int band = 0; band < 3; band++) {
                bands.read(band, row, rows[band]);
            }
            for (int column = 0; column < bands.columns(); column += step) {
                double[] colour = new double[3];
                int cell = 0;
                for (int band = 0; band < 3; band++) {
                    colour[band] = rows[band][column] / bands.format().fullScale();
                    cell = CELLS * cell + (int) Math.max(0, Math.min(CELLS - 1, CELLS * colour[band]));
                }
                all.add(colour);
                cells.computeIfAbsent(cell, key -> new Moments()).add(colour);
            }
        }
        double[] whole = all.alongAndAcross();
        return whole[1] > MOST_OFF_LINE * (whole[0] + whole[1]) && areCurve(cells);
    }

    private static boolean areCurve(Map<Integer, Moments> cells) {
        double along = 0;
        double across = 0;
        for (Moments cell : cells.values()) {
            if (cell.count >= FEWEST_IN_CELL) {
                double[] parts = cell.alongAndAcross();
                along += parts[0];
                across += parts[1];
            }
        }
        return along > 0 && across < MOST_ACROSS * along;
    }
}
