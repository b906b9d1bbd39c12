package sunbeam.precompute;

import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import sunbeam.precompute.optics.HeightMap;

/** Small surfaces for tests. */
public final class Surfaces {
    private Surfaces() {}

    /** Heights by position in metres; x to the right, y upwards, both 0 at the top left sample. */
    public static HeightMap of(int columns, int rows, double pitch, DoubleBinaryOperator height) {
        double[] heights = new double[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                heights[row * columns + column] = height.applyAsDouble(column * pitch, -row * pitch);
            }
        }
        return new HeightMap(columns, rows, pitch, pitch, heights);
    }

    public static HeightMap random(int columns, int rows, double pitch, double relief, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return of(columns, rows, pitch, (x, y) -> random.nextDouble() * relief);
    }
}
