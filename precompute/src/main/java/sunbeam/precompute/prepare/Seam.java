package sunbeam.precompute.prepare;

import sunbeam.precompute.optics.HeightMap;

/**
 * How opposite borders of a scan fit together where it repeats, along the axis along which they fit worse.
 *
 * @param jump root mean square of the step from one border to the opposite one, metres
 * @param inside the same between neighbors inside the scan
 * @param steepest the same between the two neighboring columns, or rows, that differ most
 */
public record Seam(double jump, double inside, double steepest) {
    // Metres: a thousandth of the least relief that is read; heights are rounded to less.
    private static final double ROUNDING = 1e-15;
    // Neighbors inside differ by chance less or more than their mean.
    private static final double FITTING = 2;
    // A grating's walls are alike.
    private static final double ALIKE = 1.1;

    /** Of heights of which none is missing. */
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

    /** @param squares mean squared steps from each place to the next, the last to the first */
    private static Seam of(double[] squares) {
        int inside = squares.length - 1;
        double sum = 0;
        double steepest = 0;
        for (int place = 0; place < inside; place++) {
            sum += squares[place];
            steepest = Math.max(steepest, squares[place]);
        }
        return inside == 0
                ? new Seam(0, 0, 0)
                : new Seam(Math.sqrt(squares[inside]), Math.sqrt(sum / inside), Math.sqrt(steepest));
    }

    /** The step over that between neighbors; 0 where there is none. */
    public double ratio() {
        return jump <= ROUNDING ? 0 : jump / inside;
    }

    /** Whether the surface goes on across the border as it does inside: smoothly, or with a wall like its others. */
    public boolean fits() {
        return ratio() <= FITTING || jump <= ALIKE * steepest;
    }
}
