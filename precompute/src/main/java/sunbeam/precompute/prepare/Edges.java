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

    /** Returns heights with treated borders, on the same grid. */
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
        double[] weights = weights(count);
        for (int i = 0; i < weights.length; i++) {
            int one = first + i * stride;
            int other = first + (count - 1 - i) * stride;
            double fade = weights[i] * (heights[other] - heights[one]);
            heights[one] += fade;
            heights[other] -= fade;
        }
    }

    /** Weights of the opposite border's mirror image, from the border inwards: from nearly a half to 0, like a cosine. */
    private static double[] weights(int samples) {
        int margin = (int) Math.round(MARGIN * samples);
        double[] weights = new double[margin];
        for (int i = 0; i < margin; i++) {
            weights[i] = 0.25 * (1 + Math.cos(Math.PI * (i + 0.5) / margin));
        }
        return weights;
    }
}
