package sunbeam.precompute;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import sunbeam.precompute.optics.HeightMap;

public final class Surfaces {
    private Surfaces() {}

    /** Heights by column and row, from the top left sample. */
    public interface Samples {
        double at(int column, int row);
    }

    /** Heights in meters sample by sample. */
    public static HeightMap sampled(int columns, int rows, double pitch, Samples samples) {
        double[] heights = new double[columns * rows];
        Arrays.setAll(heights, i -> samples.at(i % columns, i / columns));
        return new HeightMap(columns, rows, pitch, pitch, heights);
    }

    /** Heights by position in meters; x to the right, y upwards, both 0 at the top left sample. */
    public static HeightMap of(int columns, int rows, double pitch, DoubleBinaryOperator height) {
        return sampled(columns, rows, pitch, (column, row) -> height.applyAsDouble(column * pitch, -row * pitch));
    }

    public static HeightMap random(int columns, int rows, double pitch, double relief, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return of(columns, rows, pitch, (x, y) -> random.nextDouble() * relief);
    }
}
