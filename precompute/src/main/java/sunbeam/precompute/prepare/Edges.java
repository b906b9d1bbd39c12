package sunbeam.precompute.prepare;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;

/** Treatment of a scan's border, where its repetition begins. */
public enum Edges {
    /** The scan repeats as it is, with a step where opposite borders differ. */
    REPEAT,
    /** The repeated scan overlaps itself by 5 to 15 % of a side, where opposite borders fit best, and is cross-faded there. */
    BLEND;

    // Shares of a side: shorter overlaps leave a step, longer ones waste the scan.
    private static final double LEAST_OVERLAP = 0.05;
    private static final double MOST_OVERLAP = 0.15;
    // Lines that are compared: enough for the waves of a scan, few for large ones.
    private static final int COMPARED = 256;

    /** Returns the surface that repeats, of blended borders smaller than the scan. */
    public HeightMap apply(HeightMap field) {
        return this == REPEAT ? field : transposed(overlapped(transposed(overlapped(field))));
    }

    private static HeightMap transposed(HeightMap field) {
        double[] heights = new double[field.heights().length];
        Arrays.setAll(heights, i -> field.at(i / field.rows(), i % field.rows()));
        return new HeightMap(field.rows(), field.columns(), field.pitchY(), field.pitchX(), heights);
    }

    private static HeightMap overlapped(HeightMap field) {
        int overlap = overlap(field);
        int left = field.columns() - overlap;
        HeightMap surface = field.part(0, 0, left, field.rows());
        for (int row = 0; row < field.rows(); row++) {
            for (int i = 0; i < overlap; i++) {
                double weight = 0.5 * (1 + Math.cos(Math.PI * (i + 0.5) / overlap));
                surface.heights()[row * left + i] += weight * (field.at(left + i, row) - field.at(i, row));
            }
        }
        return surface;
    }

    /** Returns the number of columns by which left and right border overlap with the least mean square difference. */
    private static int overlap(HeightMap field) {
        int columns = field.columns();
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        int most = (int) Math.round(MOST_OVERLAP * columns);
        for (int overlap = Math.max(1, (int) Math.round(LEAST_OVERLAP * columns)); overlap <= most; overlap++) {
            double sum = 0;
            for (int row = 0; row < field.rows(); row += 1 + field.rows() / COMPARED) {
                for (int i = 0; i < overlap; i++) {
                    double difference = field.at(columns - overlap + i, row) - field.at(i, row);
                    sum += difference * difference;
                }
            }
            if (sum / overlap < least) {
                least = sum / overlap;
                best = overlap;
            }
        }
        return best;
    }

    /**
     * Step between opposite borders of a repeated scan, along the axis where it is larger, and inside, between neighbors: root mean
     * squares in meters.
     */
    public record Seam(double jump, double inside) {
        // Meters: a thousandth of the smallest relief that is read.
        private static final double ROUNDING = 1e-15;

        public static Seam of(HeightMap field) {
            double[] columns = new double[field.columns()];
            double[] rows = new double[field.rows()];
            for (int row = 0; row < rows.length; row++) {
                for (int column = 0; column < columns.length; column++) {
                    double here = field.at(column, row);
                    double right = field.at((column + 1) % columns.length, row) - here;
                    double below = field.at(column, (row + 1) % rows.length) - here;
                    columns[column] += right * right / rows.length;
                    rows[row] += below * below / columns.length;
                }
            }
            Seam alongX = of(columns);
            Seam alongY = of(rows);
            return alongX.ratio() >= alongY.ratio() ? alongX : alongY;
        }

        private static Seam of(double[] squares) {
            int inside = squares.length - 1;
            return inside == 0
                    ? new Seam(0, 0)
                    : new Seam(Math.sqrt(squares[inside]), Math.sqrt(StatUtils.sum(squares, 0, inside) / inside));
        }

        public double ratio() {
            return jump <= ROUNDING ? 0 : jump / inside;
        }
    }
}
