package sunbeam.app.gpu;

import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import sunbeam.precompute.optics.HeightMap;

/** Small surfaces for tests. */
final class Surface {
    private Surface() {}

    /** Heights by position in meters; x to the right, y upwards, both 0 at the top left sample. */
    static HeightMap of(int columns, int rows, double pitchX, double pitchY, DoubleBinaryOperator height) {
        double[] heights = new double[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                heights[row * columns + column] = height.applyAsDouble(column * pitchX, -row * pitchY);
            }
        }
        return new HeightMap(columns, rows, pitchX, pitchY, heights);
    }

    /** Square pixels. */
    static HeightMap of(int columns, int rows, double pitch, DoubleBinaryOperator height) {
        return of(columns, rows, pitch, pitch, height);
    }

    /**
     * A smooth surface without symmetry that fills a relief: three waves of whole periods, a few to the patch.
     *
     * @param relief peak to valley, meters
     */
    static HeightMap waves(int columns, int rows, double pitch, double relief) {
        double x0 = 2 * Math.PI / (columns * pitch);
        double y0 = 2 * Math.PI / (rows * pitch);
        HeightMap raw = of(
                columns,
                rows,
                pitch,
                (x, y) -> Math.sin(2 * x0 * x + y0 * y)
                        + 0.6 * Math.cos(x0 * x - 3 * y0 * y + 1)
                        + 0.3 * Math.sin(4 * x0 * x + 2));
        double scale = relief / raw.relief();
        double low = raw.minimum();
        return raw.map(height -> (height - low) * scale);
    }

    /** Independent heights, spread evenly over the relief. */
    static HeightMap noise(int columns, int rows, double pitch, double relief, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return of(columns, rows, pitch, (x, y) -> random.nextDouble() * relief);
    }
}
