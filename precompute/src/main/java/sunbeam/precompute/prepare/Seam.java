package sunbeam.precompute.prepare;

/**
 * How opposite borders of a scan fit together where it repeats, along the axis along which they fit worse.
 *
 * @param jump root mean square of the step from one border to the opposite one, metres
 * @param inside the same between neighbours inside the scan
 * @param steepest the same between the two neighbouring columns, or rows, that differ most
 */
public record Seam(double jump, double inside, double steepest) {
    // Neighbours inside differ by chance less or more than their mean.
    private static final double FITTING = 2;
    // A grating's walls are alike.
    private static final double ALIKE = 1.1;

    /** Of heights of which none is missing. */
    public static Seam of(HeightField field) {
        Seam alongX = along(field.columns(), field.rows(), field::at);
        Seam alongY = along(field.rows(), field.columns(), (place, line) -> field.at(line, place));
        return alongX.ratio() >= alongY.ratio() ? alongX : alongY;
    }

    @FunctionalInterface
    private interface Heights {
        double at(int place, int line);
    }

    private static Seam along(int places, int lines, Heights heights) {
        if (places == 1) {
            return new Seam(0, 0, 0);
        }
        double sum = 0;
        double steepest = 0;
        for (int place = 0; place + 1 < places; place++) {
            double squares = meanSquare(place, place + 1, lines, heights);
            sum += squares;
            steepest = Math.max(steepest, squares);
        }
        return new Seam(
                Math.sqrt(meanSquare(places - 1, 0, lines, heights)),
                Math.sqrt(sum / (places - 1)),
                Math.sqrt(steepest));
    }

    private static double meanSquare(int from, int to, int lines, Heights heights) {
        double sum = 0;
        for (int line = 0; line < lines; line++) {
            double step = heights.at(to, line) - heights.at(from, line);
            sum += step * step;
        }
        return sum / lines;
    }

    /** The step over that between neighbours; 0 where there is none. */
    public double ratio() {
        return jump == 0 ? 0 : jump / inside;
    }

    /** Whether the surface goes on across the border as it does inside: smoothly, or with a wall like its others. */
    public boolean fits() {
        return ratio() <= FITTING || jump <= ALIKE * steepest;
    }
}
