package sunbeam.precompute.prepare;

import java.util.Locale;

/** What becomes of a scan's border, where its repetition begins. */
public enum Edges {
    /** The scan repeats as it is, with a step where opposite borders differ. */
    REPEAT,
    /** Opposite borders are cross-faded, so that the repetition has no step. */
    BLEND;

    /** Of each side: how far from the border heights are blended. */
    public static final double MARGIN = 0.1;

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The heights with their borders treated, on the same grid. */
    public HeightField apply(HeightField field) {
        return this == REPEAT ? field : blendedAlongY(blendedAlongX(field));
    }

    private static HeightField blendedAlongX(HeightField field) {
        double[] weights = weights(field.columns());
        double[] heights = field.heights().clone();
        int last = field.columns() - 1;
        for (int row = 0; row < field.rows(); row++) {
            for (int i = 0; i < weights.length; i++) {
                double left = field.at(i, row);
                double right = field.at(last - i, row);
                heights[row * field.columns() + i] = left + weights[i] * (right - left);
                heights[row * field.columns() + last - i] = right + weights[i] * (left - right);
            }
        }
        return field.with(heights);
    }

    private static HeightField blendedAlongY(HeightField field) {
        double[] weights = weights(field.rows());
        double[] heights = field.heights().clone();
        int last = field.rows() - 1;
        for (int i = 0; i < weights.length; i++) {
            for (int column = 0; column < field.columns(); column++) {
                double top = field.at(column, i);
                double bottom = field.at(column, last - i);
                heights[i * field.columns() + column] = top + weights[i] * (bottom - top);
                heights[(last - i) * field.columns() + column] = bottom + weights[i] * (top - bottom);
            }
        }
        return field.with(heights);
    }

    /** Of the opposite border's mirror image: nearly a half at the border, falling to 0 over the margin like a cosine. */
    private static double[] weights(int samples) {
        int margin = (int) Math.round(MARGIN * samples);
        double[] weights = new double[margin];
        for (int i = 0; i < margin; i++) {
            weights[i] = 0.25 * (1 + Math.cos(Math.PI * (i + 0.5) / margin));
        }
        return weights;
    }
}
