package sunbeam.app.scene.texture;

import java.util.stream.IntStream;

/**
 * Paints texels as means of values at their four corners, which neighbors share. Shaders interpolate between texels; an edge that is
 * sharper than two of them would have teeth.
 */
final class CornerMeans {
    // Rows of a strip, whose inner corners are computed once; strips are painted in parallel.
    private static final int STRIP = 32;

    /** Returns values at a corner: column 0 is the left edge of the picture, row 0 the top edge. */
    interface Corners {
        double[] at(int column, int row);
    }

    /** Paints a texel with its mean values. */
    interface Texels {
        void paint(int column, int row, double[] mean);
    }

    private CornerMeans() {}

    static void paint(int width, int height, Corners corners, Texels texels) {
        int strips = (height + STRIP - 1) / STRIP;
        IntStream.range(0, strips).parallel().forEach(strip -> {
            int first = strip * STRIP;
            double[][] above = line(width, first, corners);
            for (int row = first; row < Math.min(height, first + STRIP); row++) {
                double[][] below = line(width, row + 1, corners);
                for (int column = 0; column < width; column++) {
                    double[] mean = new double[above[column].length];
                    for (int i = 0; i < mean.length; i++) {
                        mean[i] =
                                (above[column][i] + above[column + 1][i] + below[column][i] + below[column + 1][i]) / 4;
                    }
                    texels.paint(column, row, mean);
                }
                above = below;
            }
        });
    }

    private static double[][] line(int width, int row, Corners corners) {
        double[][] line = new double[width + 1][];
        for (int column = 0; column <= width; column++) {
            line[column] = corners.at(column, row);
        }
        return line;
    }
}
