package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.Optional;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;

/**
 * Removal of a few high edges of any shape (terraces, scratches, cracks) from heights. Differences of neighboring heights that stand out of all
 * others are the edges; the surface that has these differences alone, by least squares, is subtracted.
 */
final class TerraceEdges {
    // Samples along the longer side; the blocks of larger scans are averaged, so that an edge is few samples wide.
    private static final int GRID = 128;
    // Differences in each line of the grid that may be edges'.
    private static final int MOST_EDGES = 4;
    // Ratio of an edge to the largest other difference.
    private static final double STANDS_OUT = 2;

    private final int block;
    private final int columns;
    private final int rows;
    private final double[][] means;
    private boolean found;

    private TerraceEdges(HeightMap scan) {
        block = (Math.max(scan.columns(), scan.rows()) + GRID - 1) / GRID;
        columns = (scan.columns() + block - 1) / block;
        rows = (scan.rows() + block - 1) / block;
        means = new double[rows][columns];
        for (int i = 0; i < scan.heights().length; i++) {
            int row = i / scan.columns();
            int column = i % scan.columns();
            int high = Math.min(block, scan.rows() - row / block * block);
            int wide = Math.min(block, scan.columns() - column / block * block);
            means[row / block][column / block] += scan.heights()[i] / high / wide;
        }
    }

    /** Returns the heights without edges; empty if no difference stands out. */
    static Optional<HeightMap> removed(HeightMap scan) {
        TerraceEdges edges = new TerraceEdges(scan);
        if (edges.columns < MOST_EDGES * 3 || edges.rows < MOST_EDGES * 3) {
            return Optional.empty();
        }
        double[][] divergence = edges.divergence();
        if (!edges.found) {
            return Optional.empty();
        }
        double[][] surface = edges.surface(divergence);
        double[] heights = scan.heights().clone();
        Arrays.setAll(
                heights, i -> heights[i] - surface[i / scan.columns() / edges.block][i % scan.columns() / edges.block]);
        return Optional.of(scan.with(heights));
    }

    private double[][] divergence() {
        double[][] sum = new double[rows][columns];
        for (int axis = 0; axis < 2; axis++) {
            int dx = 1 - axis;
            int dy = axis;
            double[] steps = new double[(rows - dy) * (columns - dx)];
            int wide = columns - dx;
            Arrays.setAll(steps, i -> means[i / wide + dy][i % wide + dx] - means[i / wide][i % wide]);
            double middle = Quantiles.of(steps, 0.5);
            double[] sizes = Arrays.stream(steps)
                    .map(step -> Math.abs(step - middle))
                    .sorted()
                    .toArray();
            double least = STANDS_OUT * sizes[sizes.length - 1 - MOST_EDGES * (axis == 0 ? rows : columns)];
            for (int i = 0; i < steps.length; i++) {
                double step = steps[i] - middle;
                if (Math.abs(step) > least) {
                    found = true;
                    sum[i / wide + dy][i % wide + dx] += step;
                    sum[i / wide][i % wide] -= step;
                }
            }
        }
        return sum;
    }

    /** Solves Poisson's equation without flow across the borders, by cosine transforms. */
    private double[][] surface(double[][] divergence) {
        RealMatrix across = cosines(columns);
        RealMatrix down = cosines(rows);
        RealMatrix waves =
                down.multiply(new Array2DRowRealMatrix(divergence, false)).multiply(across.transpose());
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                double curvature = 2 * Math.cos(Math.PI * x / columns) + 2 * Math.cos(Math.PI * y / rows) - 4;
                waves.setEntry(y, x, x + y == 0 ? 0 : -waves.getEntry(y, x) / curvature);
            }
        }
        return down.transpose().multiply(waves).multiply(across).getData();
    }

    private static RealMatrix cosines(int count) {
        RealMatrix matrix = new Array2DRowRealMatrix(count, count);
        for (int k = 0; k < count; k++) {
            for (int i = 0; i < count; i++) {
                matrix.setEntry(
                        k, i, Math.sqrt((k == 0 ? 1.0 : 2.0) / count) * Math.cos(Math.PI * k * (i + 0.5) / count));
            }
        }
        return matrix;
    }
}
