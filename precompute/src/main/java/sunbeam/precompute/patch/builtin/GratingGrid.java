package sunbeam.precompute.patch.builtin;

import java.util.function.DoubleUnaryOperator;
import sunbeam.precompute.optics.HeightMap;

/**
 * One period of a surface that varies along x only, as a square patch.
 *
 * @param period width and height of the patch in metres
 * @param columns samples along x
 * @param rows samples along y; all alike, so few are enough
 */
public record GratingGrid(double period, int columns, int rows) {
    public GratingGrid {
        Parameters.requirePositive("period", period);
        Parameters.requireSamples("columns", columns, 2);
        Parameters.requireSamples("rows", rows, 1);
    }

    /**
     * The usual resolution: 128 columns, so that the orders in sight (up to 13 for 2.5 um and 380 nm) are free of
     * aliases, and 32 rows, which are 78 nm apart for 2.5 um and so finer than a quarter of 380 nm.
     */
    static GratingGrid ofPeriod(double period) {
        return new GratingGrid(period, 128, 32);
    }

    /** Heights by a function of the place within the period, which goes from 0 (left) to 1 (right). */
    HeightMap sample(DoubleUnaryOperator profile) {
        double[] heights = new double[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = profile.applyAsDouble((i % columns + 0.5) / columns);
        }
        return new HeightMap(columns, rows, period / columns, period / rows, heights);
    }
}
