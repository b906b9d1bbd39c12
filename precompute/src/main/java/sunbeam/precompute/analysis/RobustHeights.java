package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.Optional;
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
 *
 * @param level heights before they are clipped
 */
record RobustHeights(HeightMap level) {
    // More belong to the surface: three lines across the scan have six edges.
    private static final int MOST_JUMPS = 4;
    // Ratio of a jump to the largest other step between rows.
    private static final double STANDS_OUT = 2;
    // Evenly spaced columns: the error of their median is a tenth of their spread.
    private static final int MOST_COLUMNS = 256;
    private static final int ITERATIONS = 12;
    // Relative change of the deviation that ends them: far below the clipped range.
    private static final double SETTLED = 1e-3;
    private static final double HUBER = 1.5;
    private static final double GAUSSIAN = 1.4826;
    private static final int TERMS = 6;
    // Samples that the polynomial is fitted to, one of each of as many runs of samples.
    private static final int FITTED = 20000;
    // Tiles along each axis. Dust, scratches and a ridge lie in less than half of the small tiles, and in less than
    // three quarters of the large ones, of which each has the tops and bottoms of a surface that repeats.
    private static final int SMALL_TILES = 20;
    private static final int LARGE_TILES = 6;
    // Share of the distance of the usual tops and bottoms: lines of uneven height stay within it.
    private static final double FAR = 0.5;
    // A cut of this width leaves of a Gaussian ridge, five times as high as lines, less than their height. A cut twice
    // as
    // wide leaves too few lines beside a ridge along them.
    private static final double WIDER = 1.5;
    // A plane that a ridge tilts makes other heights seem too high.
    private static final int CUTS = 3;
    // Share of the scan: what lies beyond may be lines that cover the rest.
    private static final double LEAST_LEFT = 0.5;

    /** @param scan complete heights, meters */
    static RobustHeights of(HeightMap scan) {
        double[] heights = scan.heights().clone();
        undoJumps(scan, heights);
        level(scan, heights, new boolean[heights.length]);
        return new RobustHeights(scan.with(heights));
    }

    HeightMap clipped() {
        return clipped(level, level.heights(), new boolean[level.heights().length]);
    }

    /** Returns heights in which high ridges, dust and scratches, with their flanks, count as not measured: they have the mean; empty without any. */
    Optional<HeightMap> withoutRidges() {
        double[] heights = level.heights().clone();
        boolean[] cut = new boolean[heights.length];
        int[] left = {};
        for (int i = 0; i < CUTS; i++) {
            boolean[] ridges = ridges(level, heights, cut);
            left = IntStream.range(0, ridges.length).filter(k -> !ridges[k]).toArray();
            cut = ridges;
            if (left.length == cut.length || left.length == 0) {
                return Optional.empty();
            }
            level(level, heights, cut);
        }
        if (left.length < LEAST_LEFT * cut.length) {
            return Optional.empty();
        }
        HeightMap clipped = clipped(level, heights, cut);
        double mean = Arrays.stream(left)
                .mapToDouble(i -> clipped.heights()[i])
                .average()
                .orElseThrow();
        boolean[] ridges = cut;
        Arrays.setAll(heights, i -> ridges[i] ? mean : clipped.heights()[i]);
        return Optional.of(level.with(heights));
    }

    /** Marks samples beyond the usual tops and bottoms by half of their distance, and half as much of the flanks around them. */
    private static boolean[] ridges(HeightMap scan, double[] heights, boolean[] before) {
        double[] usual = usual(scan, heights, before);
        double far = FAR * (usual[1] - usual[0]);
        double[] reach = new double[heights.length];
        Arrays.setAll(
                reach, i -> heights[i] > usual[1] + far || heights[i] < usual[0] - far ? Double.NEGATIVE_INFINITY : 0);
        spread(scan, reach);
        Arrays.setAll(reach, i -> -WIDER * reach[i]);
        spread(scan, reach);
        boolean[] ridges = new boolean[reach.length];
        for (int i = 0; i < ridges.length; i++) {
            ridges[i] = reach[i] > 0;
        }
        return ridges;
    }

    /** Raises values to those of neighbors less the distance, samples: minus the distance to zeros, or what lies within positive ones. */
    private static void spread(HeightMap scan, double[] values) {
        int columns = scan.columns();
        for (int sign = 1; sign >= -1; sign -= 2) {
            for (int k = 0; k < values.length; k++) {
                int i = sign > 0 ? k : values.length - 1 - k;
                for (int n = 0; n < 4; n++) {
                    int dx = n == 3 ? -sign : sign * (n - 1);
                    int other = i + dx - (n == 3 ? 0 : sign * columns);
                    int column = i % columns + dx;
                    if (column >= 0 && column < columns && other >= 0 && other < values.length) {
                        values[i] = Math.max(values[i], values[other] - (n == 0 || n == 2 ? Math.sqrt(2) : 1));
                    }
                }
            }
        }
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

    private static void level(HeightMap scan, double[] heights, boolean[] cut) {
        int stride = Math.max(1, heights.length / FITTED);
        SplittableRandom random = new SplittableRandom(1);
        int[] fitted = IntStream.range(0, heights.length / stride)
                .map(k -> k * stride + (stride > 1 ? random.nextInt(stride) : 0))
                .filter(i -> !cut[i])
                .toArray();
        int count = fitted.length;
        double[] rest = new double[count];
        double[][] terms = new double[count][];
        double[] values = new double[count];
        for (int k = 0; k < count; k++) {
            terms[k] = terms(scan, fitted[k]);
            values[k] = heights[fitted[k]] - heights[0];
        }
        double[] weights = new double[count];
        Arrays.fill(weights, 1);
        double[] fit = new double[TERMS];
        double scale = 1;
        double before = 0;
        for (int n = 0; n < ITERATIONS && Math.abs(scale - before) > SETTLED * scale; n++) {
            before = scale;
            double[][] normal = new double[TERMS][TERMS];
            double[] right = new double[TERMS];
            for (int k = 0; k < count; k++) {
                for (int a = 0; a < TERMS; a++) {
                    double wa = weights[k] * terms[k][a];
                    right[a] += wa * values[k];
                    for (int b = 0; b <= a; b++) {
                        normal[a][b] += wa * terms[k][b];
                    }
                }
            }
            for (int a = 0; a < TERMS; a++) {
                for (int b = a + 1; b < TERMS; b++) {
                    normal[a][b] = normal[b][a];
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
            scale = HUBER * GAUSSIAN * Quantiles.of(sizes, 0.5);
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

    /** Clips heights beyond the usual tops and bottoms. */
    private static HeightMap clipped(HeightMap scan, double[] heights, boolean[] cut) {
        double[] usual = usual(scan, heights, cut);
        double[] clipped = new double[heights.length];
        Arrays.setAll(clipped, i -> Math.max(usual[0], Math.min(usual[1], heights[i])));
        return scan.with(clipped);
    }

    /** Returns the usual bottoms and tops of small tiles, or of large ones if these are farther: pits may be rare. */
    private static double[] usual(HeightMap scan, double[] heights, boolean[] cut) {
        double[] small = usual(scan, heights, cut, SMALL_TILES, 0.5);
        double[] large = usual(scan, heights, cut, LARGE_TILES, 0.25);
        return new double[] {Math.min(small[0], large[0]), Math.max(small[1], large[1])};
    }

    /** Returns the bottom and top that a share of the tiles stay within. */
    private static double[] usual(HeightMap scan, double[] heights, boolean[] cut, int tiles, double share) {
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
                tops[tile] = cut[i] ? tops[tile] : Math.max(tops[tile], heights[i]);
                bottoms[tile] = cut[i] ? bottoms[tile] : Math.min(bottoms[tile], heights[i]);
            }
        }
        double[] low = Arrays.stream(bottoms).filter(Double::isFinite).toArray();
        double[] high = Arrays.stream(tops).filter(Double::isFinite).toArray();
        return new double[] {Quantiles.of(low, 1 - share), Quantiles.of(high, share)};
    }
}
