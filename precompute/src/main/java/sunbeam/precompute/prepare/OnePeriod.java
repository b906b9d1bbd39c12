package sunbeam.precompute.prepare;

/** Recognises heights that are one period, or very few, of a surface. */
public final class OnePeriod {
    // Larger patches are scans: half of sunlight's coherence length.
    private static final double LARGEST = 32.5e-6;
    // Along each axis; more are a grating that happens to fit.
    private static final int MOST_PERIODS = 2;
    // Of the heights' variance, in one frequency; noise has less in each.
    private static final double LEAST_SHARE = 0.4;
    // Of the relief: rounding of computed heights. No instrument measures lines as alike.
    private static final double SAME = 1e-6;
    // Of the largest change of slope inside; that of a wall or crest may lie at the border alone.
    private static final double SHARPEST = 3;
    // What rounding to 8 bits leaves of an even ramp is a thousandth of it.
    private static final double EVEN = 5e-3;

    private OnePeriod() {}

    /** Whether the surface goes on smoothly across all borders and one low frequency holds most of it. */
    public static boolean is(HeightField field) {
        if (Math.max(field.width(), field.height()) > LARGEST || hasGaps(field)) {
            return false;
        }
        if (!Seam.of(field).fits()) {
            return false;
        }
        double share = lowShare(field);
        return share >= LEAST_SHARE && share > bowShare(field);
    }

    /**
     * Whether the heights are, beyond that, those of lines that somebody drew or computed: the same all along one axis. A
     * measured scan has borders that fit and one low frequency, too, where it shows a terrace's step, a plateau or rows
     * that wander, and nothing in the heights tells that from a grating's one period but that measured lines differ.
     */
    public static boolean isDrawn(HeightField field) {
        boolean alongX = field.columns() > 1 && isSame(field, 0, 1);
        boolean alongY = field.rows() > 1 && isSame(field, 1, 0);
        return ((alongX && bendsNoMoreAtItsBorder(field, field.rows(), 0, 1))
                        || (alongY && bendsNoMoreAtItsBorder(field, field.columns(), 1, 0)))
                && is(field);
    }

    /**
     * Whether the slope changes from the last line to the first as it does from line to line elsewhere: where two and a half
     * periods are repeated the heights meet, but not their slopes.
     *
     * @param count of lines
     * @param stepX columns from one line to the next
     * @param stepY rows from one line to the next
     */
    private static boolean bendsNoMoreAtItsBorder(HeightField field, int count, int stepX, int stepY) {
        double most = 0;
        double border = 0;
        for (int line = 0; line < count; line++) {
            double before = at(field, (line + count - 1) % count, stepX, stepY);
            double here = at(field, line, stepX, stepY);
            double after = at(field, (line + 1) % count, stepX, stepY);
            double bend = Math.abs(after - 2 * here + before);
            boolean outer = line == 0 || line == count - 1;
            border = outer ? Math.max(border, bend) : border;
            most = outer ? most : Math.max(most, bend);
        }
        return border <= SHARPEST * most;
    }

    private static double at(HeightField field, int line, int stepX, int stepY) {
        return field.at(line * stepX, line * stepY);
    }

    /**
     * Whether all heights are those of the first column, or row.
     *
     * @param columnFactor 0 to compare with the first column, 1 with the own one
     * @param rowFactor 0 to compare with the first row, 1 with the own one
     */
    private static boolean isSame(HeightField field, int columnFactor, int rowFactor) {
        double largest = 0;
        double least = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        for (int row = 0; row < field.rows(); row++) {
            for (int column = 0; column < field.columns(); column++) {
                double here = field.at(column, row);
                double first = field.at(columnFactor * column, rowFactor * row);
                largest = Math.max(largest, Math.abs(here - first));
                least = Math.min(least, here);
                highest = Math.max(highest, here);
            }
        }
        return largest <= SAME * (highest - least);
    }

    /**
     * The share of the variance that a surface of second degree has and a plane has not: a scanner's bow has equal heights at
     * opposite borders, too, but is a parabola rather than a wave. Of one sine's period it has at most 0.92, of a triangle's
     * 0.94, of a blazed grating's, which is a plane with a fall, next to nothing.
     */
    private static double bowShare(HeightField field) {
        double all = Polynomial.fit(field, 1).variance();
        double beyondPlane =
                Polynomial.fit(field, 3).variance() - Polynomial.fit(field, 6).variance();
        return all > 0 ? beyondPlane / all : 0;
    }

    /** Whether the heights are one even ramp and nothing else: a tilted mirror, or one period of a blazed grating. */
    public static boolean isRamp(HeightField field) {
        if (Math.max(field.width(), field.height()) > LARGEST || hasGaps(field)) {
            return false;
        }
        Tilt tilt = Tilt.of(field);
        return tilt.rise() > 0 && 1 - tilt.share() < EVEN * EVEN;
    }

    private static boolean hasGaps(HeightField field) {
        for (double height : field.heights()) {
            if (!Double.isFinite(height)) {
                return true;
            }
        }
        return false;
    }

    /** The largest share of the variance that a wave of at most two periods along each axis has. */
    private static double lowShare(HeightField field) {
        double[] heights = Levelling.MEAN.apply(field).heights();
        double variance = 0;
        for (double height : heights) {
            variance += height * height / heights.length;
        }
        double largest = 0;
        for (int jx = -MOST_PERIODS; jx <= MOST_PERIODS; jx++) {
            double[][] ofRows = alongX(field, heights, jx);
            for (int jy = jx > 0 ? 0 : 1; jy <= MOST_PERIODS; jy++) {
                largest = Math.max(largest, power(field, ofRows, jy));
            }
        }
        // A bin and its mirror image make one wave.
        return variance > 0 ? 2 * largest / variance : 0;
    }

    /** A bin of each row: real parts, imaginary parts. */
    private static double[][] alongX(HeightField field, double[] heights, int jx) {
        double[] cosines = new double[field.columns()];
        double[] sines = new double[field.columns()];
        for (int column = 0; column < field.columns(); column++) {
            double angle = 2 * Math.PI * jx * column / field.columns();
            cosines[column] = Math.cos(angle);
            sines[column] = Math.sin(angle);
        }
        double[][] bins = new double[2][field.rows()];
        for (int row = 0; row < field.rows(); row++) {
            for (int column = 0, i = row * field.columns(); column < field.columns(); column++, i++) {
                bins[0][row] += heights[i] * cosines[column];
                bins[1][row] += heights[i] * sines[column];
            }
        }
        return bins;
    }

    private static double power(HeightField field, double[][] ofRows, int jy) {
        double real = 0;
        double imaginary = 0;
        for (int row = 0; row < field.rows(); row++) {
            double angle = 2 * Math.PI * jy * row / field.rows();
            real += ofRows[0][row] * Math.cos(angle) - ofRows[1][row] * Math.sin(angle);
            imaginary += ofRows[0][row] * Math.sin(angle) + ofRows[1][row] * Math.cos(angle);
        }
        double samples = (double) field.columns() * field.rows();
        return (real * real + imaginary * imaginary) / (samples * samples);
    }
}
