package sunbeam.precompute.prepare;

/**
 * How opposite borders of a scan fit together where it repeats, along the axis along which they fit worse.
 *
 * @param jump root mean square of the step from one border to the opposite one, metres
 * @param inside the same between neighbours inside the scan
 * @param steepest the same between the two neighbouring columns, or rows, that differ most
 */
public record Seam(double jump, double inside, double steepest) {
    /** Of a scan without border. */
    public static final Seam NONE = new Seam(0, 0, 0);

    // Metres: a thousandth of the least relief that is read; heights are rounded to less.
    private static final double ROUNDING = 1e-15;
    // Neighbours inside differ by chance less or more than their mean.
    private static final double FITTING = 2;
    // A grating's walls are alike.
    private static final double ALIKE = 1.1;

    /** Of heights of which none is missing. */
    public static Seam of(HeightField field) {
        Seam alongX = of(betweenColumns(field), field.rows());
        Seam alongY = of(betweenRows(field), field.columns());
        return alongX.ratio() >= alongY.ratio() ? alongX : alongY;
    }

    /** @param squares sums over lines of the squared steps from each place to the next, the last to the first */
    private static Seam of(double[] squares, int lines) {
        int inside = squares.length - 1;
        if (inside == 0) {
            return NONE;
        }
        double sum = 0;
        double steepest = 0;
        for (int place = 0; place < inside; place++) {
            sum += squares[place] / lines;
            steepest = Math.max(steepest, squares[place] / lines);
        }
        return new Seam(Math.sqrt(squares[inside] / lines), Math.sqrt(sum / inside), Math.sqrt(steepest));
    }

    private static double[] betweenColumns(HeightField field) {
        int columns = field.columns();
        double[] squares = new double[columns];
        for (int row = 0; row < field.rows(); row++) {
            for (int column = 0; column < columns; column++) {
                double step = field.at(column + 1 == columns ? 0 : column + 1, row) - field.at(column, row);
                squares[column] += step * step;
            }
        }
        return squares;
    }

    private static double[] betweenRows(HeightField field) {
        double[] squares = new double[field.rows()];
        for (int row = 0; row < field.rows(); row++) {
            int next = row + 1 == field.rows() ? 0 : row + 1;
            for (int column = 0; column < field.columns(); column++) {
                double step = field.at(column, next) - field.at(column, row);
                squares[row] += step * step;
            }
        }
        return squares;
    }

    /** The step over that between neighbours; 0 where there is none. */
    public double ratio() {
        return jump <= ROUNDING ? 0 : jump / inside;
    }

    /** Whether the surface goes on across the border as it does inside: smoothly, or with a wall like its others. */
    public boolean fits() {
        return ratio() <= FITTING || jump <= ALIKE * steepest;
    }
}
