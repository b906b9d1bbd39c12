package sunbeam.precompute.prepare;

import sunbeam.precompute.optics.HeightMap;

/** Treatment of a scan's border, where its repetition begins. */
public enum Edges {
    /** The scan repeats as it is, with a step where opposite borders differ. */
    REPEAT,
    /** Opposite borders are cross-faded, so that the repetition has no step. */
    BLEND;

    /** Share of each side over which heights are blended. */
    public static final double MARGIN = 0.1;

    public HeightMap apply(HeightMap field) {
        if (this == REPEAT) {
            return field;
        }
        double[] heights = field.heights().clone();
        int columns = field.columns();
        for (int row = 0; row < field.rows(); row++) {
            blend(heights, row * columns, 1, columns);
        }
        for (int column = 0; column < columns; column++) {
            blend(heights, column, columns, field.rows());
        }
        return field.with(heights);
    }

    private static void blend(double[] heights, int first, int stride, int count) {
        int margin = (int) Math.round(MARGIN * count);
        for (int i = 0; i < margin; i++) {
            // From nearly a half at the border to 0, like a cosine.
            double weight = 0.25 * (1 + Math.cos(Math.PI * (i + 0.5) / margin));
            int one = first + i * stride;
            int other = first + (count - 1 - i) * stride;
            double fade = weight * (heights[other] - heights[one]);
            heights[one] += fade;
            heights[other] -= fade;
        }
    }

    /**
     * Step between opposite borders of a repeated scan, along the axis where it is larger; inside, between neighbors; and between the two
     * neighboring columns or rows that differ most: root mean squares in meters.
     */
    public record Seam(double jump, double inside, double steepest) {
        // Meters: a thousandth of the smallest relief that is read.
        private static final double ROUNDING = 1e-15;
        // Ratio of the jump to the steps inside that counts as fitting.
        private static final double FITTING = 2;
        // Ratio to the steepest step at which the jump counts as another wall of a grating.
        private static final double ALIKE = 1.1;

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
            double sum = 0;
            double steepest = 0;
            for (int i = 0; i < inside; i++) {
                sum += squares[i];
                steepest = Math.max(steepest, squares[i]);
            }
            return inside == 0
                    ? new Seam(0, 0, 0)
                    : new Seam(Math.sqrt(squares[inside]), Math.sqrt(sum / inside), Math.sqrt(steepest));
        }

        public double ratio() {
            return jump <= ROUNDING ? 0 : jump / inside;
        }

        /** True if the surface continues across the border as it does inside: smoothly, or with a wall like its others. */
        public boolean fits() {
            return ratio() <= FITTING || jump <= ALIKE * steepest;
        }
    }
}
