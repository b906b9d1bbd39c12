package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;

/**
 * Heights from which the faults of a scan are removed before the search for waves: jumps between rows are undone, a plane and a bow are
 * subtracted that few deviating heights do not bend (Huber's weights), and heights are clipped at the median over tiles of the tiles' highest
 * and lowest.
 */
final class RobustHeights {
    // More belong to the surface: three lines across the scan have six edges.
    private static final int MOST_JUMPS = 4;
    // Ratio of a jump to the largest other step between rows.
    private static final double STANDS_OUT = 2;
    // Evenly spaced columns: the error of their median is a tenth of their spread.
    private static final int MOST_COLUMNS = 256;
    private static final int ITERATIONS = 12;
    private static final double HUBER = 1.5;
    private static final double GAUSSIAN = 1.4826;
    private static final int TERMS = 6;
    // Samples that the polynomial is fitted to, one of each of as many runs of samples.
    private static final int FITTED = 20000;
    // Tiles along each axis. Dust, scratches and a ridge lie in less than half of the small tiles, and in less than
    // three quarters of the
    // large ones, of which each has the tops and bottoms of a surface that repeats.
    private static final int SMALL_TILES = 20;
    private static final int LARGE_TILES = 6;

    private RobustHeights() {}

    /** @param scan complete heights, meters */
    static HeightMap of(HeightMap scan) {
        double[] heights = scan.heights().clone();
        undoJumps(scan, heights);
        level(scan, heights);
        clip(scan, heights);
        return scan.with(heights);
    }

    /** Undoes up to four steps between rows that are more than twice as high as all others. */
    private static void undoJumps(HeightMap scan, double[] heights) {
        int rows = scan.rows();
        if (rows < 3 * MOST_JUMPS) {
            return;
        }
        int columns = scan.columns();
        int stride = (columns + MOST_COLUMNS - 1) / MOST_COLUMNS;
        double[] steps = IntStream.range(1, rows)
                .parallel()
                .mapToDouble(row -> Quantiles.of(
                        IntStream.range(0, columns / stride)
                                .mapToDouble(i ->
                                        heights[row * columns + i * stride] - heights[(row - 1) * columns + i * stride])
                                .toArray(),
                        0.5))
                .toArray();
        double middle = Quantiles.of(steps, 0.5);
        double[] sizes = Arrays.stream(steps)
                .map(step -> Math.abs(step - middle))
                .sorted()
                .toArray();
        double least = STANDS_OUT * sizes[sizes.length - 1 - MOST_JUMPS];
        double shift = 0;
        for (int row = 1; row < rows; row++) {
            double step = steps[row - 1] - middle;
            shift += Math.abs(step) > least ? step : 0;
            for (int i = row * columns; i < (row + 1) * columns && shift != 0; i++) {
                heights[i] -= shift;
            }
        }
    }

    private static double[] terms(HeightMap scan, int i) {
        int row = i / scan.columns();
        double x = scan.columns() > 1 ? 2.0 * (i % scan.columns()) / (scan.columns() - 1) - 1 : 0;
        double y = scan.rows() > 1 ? 2.0 * row / (scan.rows() - 1) - 1 : 0;
        return new double[] {1, x, y, x * x, x * y, y * y};
    }

    private static void level(HeightMap scan, double[] heights) {
        int stride = Math.max(1, heights.length / FITTED);
        int count = heights.length / stride;
        double[] rest = new double[count];
        double[][] terms = new double[count][];
        double[] values = new double[count];
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < count; k++) {
            int i = k * stride + (stride > 1 ? random.nextInt(stride) : 0);
            terms[k] = terms(scan, i);
            values[k] = heights[i] - heights[0];
        }
        double[] weights = new double[count];
        Arrays.fill(weights, 1);
        double[] fit = new double[TERMS];
        for (int n = 0; n < ITERATIONS; n++) {
            double[][] normal = new double[TERMS][TERMS];
            double[] right = new double[TERMS];
            for (int k = 0; k < count; k++) {
                for (int a = 0; a < TERMS; a++) {
                    double wa = weights[k] * terms[k][a];
                    right[a] += wa * values[k];
                    for (int b = 0; b < TERMS; b++) {
                        normal[a][b] += wa * terms[k][b];
                    }
                }
            }
            fit = new SingularValueDecomposition(new Array2DRowRealMatrix(normal))
                    .getSolver()
                    .solve(new ArrayRealVector(right))
                    .toArray();
            double[] sizes = new double[count];
            for (int k = 0; k < count; k++) {
                rest[k] = values[k] - CoarseWave.dot(fit, terms[k]);
                sizes[k] = Math.abs(rest[k]);
            }
            double scale = HUBER * GAUSSIAN * Quantiles.of(sizes, 0.5);
            for (int k = 0; k < count; k++) {
                weights[k] = Math.abs(rest[k]) <= scale ? 1 : scale / Math.abs(rest[k]);
            }
        }
        double offset = heights[0];
        double[] found = fit;
        IntStream.range(0, heights.length)
                .parallel()
                .forEach(i -> heights[i] -= offset + CoarseWave.dot(found, terms(scan, i)));
    }

    /** Clips heights beyond the usual tops and bottoms of small tiles, or of large ones if these are farther: pits may be rare. */
    private static void clip(HeightMap scan, double[] heights) {
        double[] small = usual(scan, heights, SMALL_TILES, 0.5);
        double[] large = usual(scan, heights, LARGE_TILES, 0.25);
        double bottom = Math.min(small[0], large[0]);
        double top = Math.max(small[1], large[1]);
        Arrays.setAll(heights, i -> Math.max(bottom, Math.min(top, heights[i])));
    }

    /** Returns the bottom and top that a share of the tiles stay within. */
    private static double[] usual(HeightMap scan, double[] heights, int tiles, double share) {
        int across = Math.min(tiles, scan.columns());
        int down = Math.min(tiles, scan.rows());
        double[] tops = new double[across * down];
        double[] bottoms = new double[across * down];
        Arrays.fill(tops, Double.NEGATIVE_INFINITY);
        Arrays.fill(bottoms, Double.POSITIVE_INFINITY);
        for (int row = 0, i = 0; row < scan.rows(); row++) {
            int first = across * (int) ((long) row * down / scan.rows());
            for (int column = 0; column < scan.columns(); column++, i++) {
                int tile = first + (int) ((long) column * across / scan.columns());
                tops[tile] = Math.max(tops[tile], heights[i]);
                bottoms[tile] = Math.min(bottoms[tile], heights[i]);
            }
        }
        return new double[] {Quantiles.of(bottoms, 1 - share), Quantiles.of(tops, share)};
    }
}
