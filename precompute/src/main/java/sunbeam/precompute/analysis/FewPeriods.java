package sunbeam.precompute.analysis;

import java.util.Locale;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.units.Lengths;

/**
 * A wave that a scan shows some three times: too few to be sure of a period, but no lack of one. It is told where the scan,
 * moved along its lines' normal, falls onto itself again, and once more after twice that distance (Pearson's correlation of the
 * heights of the overlap). Noise and fractal surfaces do not, of which simulated ones were tried.
 *
 * @param period about, metres
 * @param direction across the lines, radians counter-clockwise from +x, 0 to below pi
 * @param count how many fit into the scan along the direction
 */
public record FewPeriods(double period, double direction, double count) {
    // What falls onto itself by chance does so with 0.8 at most, and not twice.
    private static final double ALIKE = 0.9;
    private static final double ALIKE_TWICE = 0.8;
    // Between two lines there is something else.
    private static final double UNLIKE = 0.5;
    // Periods in the scan. Of fewer, a half would be compared; of more, the spectrum tells.
    private static final double FEWEST = 2.5;
    private static final double MOST = 6;
    // Of the variance, in what is much coarser than the samples that are compared: fine waves have a moire with these.
    private static final double LEAST_COARSE = 0.5;
    private static final int COARSE = 4;
    // Shifts over the scan's length.
    private static final int STEPS = 240;
    // Samples along a side that are compared.
    private static final int SIDE = 128;
    // Of the places of a scan, in the smallest overlap that counts.
    private static final int FEWEST_PLACES = 64;

    /** The wave of a scan without missing samples in which nothing else repeats; empty where there is none. */
    public static Optional<FewPeriods> in(HeightMap map) {
        if (map.columns() < 8 || map.rows() < 8 || !(map.relief() > 0)) {
            return Optional.empty();
        }
        HeightMap level = map.levelled(Levelling.PLANE);
        Shifted heights = Shifted.of(level);
        if (heights.averaged().variance() < LEAST_COARSE * StatUtils.populationVariance(level.toArray())) {
            return Optional.empty();
        }
        double direction = heights.steepestDirection();
        double length = Math.min(
                map.width() / Math.max(1e-12, Math.abs(Math.cos(direction))),
                map.height() / Math.max(1e-12, Math.abs(Math.sin(direction))));
        double[] alike = new double[STEPS];
        for (int i = 0; i < STEPS; i++) {
            alike[i] = heights.correlation(i * length / STEPS, direction);
        }
        for (int i = (int) (STEPS / MOST); i <= STEPS / FEWEST; i++) {
            if (isReturn(alike, i)) {
                double turned = direction < 0 ? direction + Math.PI : direction;
                return Optional.of(new FewPeriods(i * length / STEPS, turned % Math.PI, (double) STEPS / i));
            }
        }
        return Optional.empty();
    }

    /** Whether the scan falls onto itself after a shift and after twice that, and not in between. */
    private static boolean isReturn(double[] alike, int shift) {
        boolean top = alike[shift] >= ALIKE && alike[shift] >= alike[shift - 1] && alike[shift] >= alike[shift + 1];
        double between = 1;
        for (int i = shift / 4; i <= 3 * shift / 4; i++) {
            between = Math.min(between, alike[i]);
        }
        return top && between <= UNLIKE && alike[2 * shift] >= ALIKE_TWICE;
    }

    /** How many times, in words: "a wave of about 2.9 um ...". */
    public String describe() {
        return String.format(
                Locale.ROOT,
                "a wave of about %s in direction %.0f degrees or so is seen %.1f times: too few to be sure of a period",
                Lengths.rounded(period, 2),
                Math.toDegrees(direction),
                count);
    }

    /** Heights on a grid coarse enough to be compared with themselves many times. */
    private record Shifted(int columns, int rows, double pitchX, double pitchY, double[] heights) {
        /** Means of blocks of samples; what is left over at the right and the bottom is left out. */
        static Shifted of(HeightMap map) {
            return of(map, Math.max(1, map.columns() / SIDE), Math.max(1, map.rows() / SIDE));
        }

        private static Shifted of(HeightMap map, int blockX, int blockY) {
            int columns = map.columns() / blockX;
            int rows = map.rows() / blockY;
            double[] heights = new double[columns * rows];
            for (int row = 0; row < rows * blockY; row++) {
                for (int column = 0; column < columns * blockX; column++) {
                    heights[row / blockY * columns + column / blockX] += map.at(column, row) / (blockX * blockY);
                }
            }
            return new Shifted(columns, rows, blockX * map.pitchX(), blockY * map.pitchY(), heights);
        }

        /** Of some samples a side. */
        Shifted averaged() {
            return of(new HeightMap(columns, rows, pitchX, pitchY, heights), COARSE, COARSE);
        }

        double variance() {
            return StatUtils.populationVariance(heights);
        }

        /** Principal axis of the gradients, radians, -pi/2 to pi/2. */
        double steepestDirection() {
            double cosine = 0;
            double sine = 0;
            for (int row = 1; row + 1 < rows; row++) {
                for (int column = 1; column + 1 < columns; column++) {
                    int here = row * columns + column;
                    double alongX = (heights[here + 1] - heights[here - 1]) / pitchX;
                    // Rows run downwards, y upwards.
                    double alongY = (heights[here - columns] - heights[here + columns]) / pitchY;
                    cosine += alongX * alongX - alongY * alongY;
                    sine += 2 * alongX * alongY;
                }
            }
            return 0.5 * Math.atan2(sine, cosine);
        }

        /** Of the heights with those a distance away, over all places where both are; 0 where they are too few. */
        double correlation(double distance, double direction) {
            double stepX = distance * Math.cos(direction) / pitchX;
            double stepY = -distance * Math.sin(direction) / pitchY;
            double[] sums = new double[5];
            int count = 0;
            for (int row = 0; row < rows; row++) {
                double y = row + stepY;
                for (int column = 0; column < columns && y >= 0 && y <= rows - 1; column++) {
                    double x = column + stepX;
                    if (x <= columns - 1) {
                        double here = heights[row * columns + column];
                        double there = at(x, y);
                        sums[0] += here;
                        sums[1] += there;
                        sums[2] += here * here;
                        sums[3] += there * there;
                        sums[4] += here * there;
                        count++;
                    }
                }
            }
            double hereVariance = sums[2] - sums[0] * sums[0] / count;
            double thereVariance = sums[3] - sums[1] * sums[1] / count;
            double product = Math.sqrt(hereVariance * thereVariance);
            return count < FEWEST_PLACES || !(product > 0) ? 0 : (sums[4] - sums[0] * sums[1] / count) / product;
        }

        /** Bilinear between samples. */
        private double at(double x, double y) {
            int left = Math.min((int) x, columns - 2);
            int top = Math.min((int) y, rows - 2);
            int first = top * columns + left;
            double upper = heights[first] * (left + 1 - x) + heights[first + 1] * (x - left);
            double lower = heights[first + columns] * (left + 1 - x) + heights[first + columns + 1] * (x - left);
            return upper * (top + 1 - y) + lower * (y - top);
        }
    }
}
