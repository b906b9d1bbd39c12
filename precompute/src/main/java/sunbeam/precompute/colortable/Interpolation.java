package sunbeam.precompute.colortable;

/**
 * The filter between a level's texels, through square roots of X, Y and Z: roots, because a spline rings. Beside a peak of 1 its error falls
 * by 3.7 a texel, and of what is as dark as 1e-6 nothing would be left; in roots that is 1e-3.
 */
public enum Interpolation {
    /**
     * Cubic B-splines (M. Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16
     * (1999)): 16 coefficients each, right at every place.
     */
    CUBIC("cubicXyz", 0, LevelBaking.MARGIN) {
        @Override
        void toCoefficients(float[] plane, int rows, int columns) {
            float pole = (float) POLE;
            float factor = pole;
            for (int row = 1; row < HORIZON; row++) {
                int at = row % (2 * (rows - 1));
                addRow(plane, 0, (at < rows ? at : 2 * (rows - 1) - at) * columns, factor, columns);
                factor *= pole;
            }
            // (1 - POLE) (1 - 1 / POLE) = 6.
            forwards(plane, rows, columns, 6, 6);
            int last = (rows - 1) * columns;
            float end = pole / (pole * pole - 1);
            for (int i = 0; i < columns; i++) {
                plane[last + i] = end * (plane[last + i] + pole * plane[last - columns + i]);
            }
            for (int at = last - columns; at >= 0; at -= columns) {
                for (int i = 0; i < columns; i++) {
                    plane[at + i] = pole * (plane[at + columns + i] - plane[at + i]);
                }
            }
        }

        @Override
        double[] weights(double t) {
            double s = 1 - t;
            return new double[] {
                s * s * s / 6, 2.0 / 3 - 0.5 * t * t * (2 - t), 2.0 / 3 - 0.5 * s * s * (2 - s), t * t * t / 6
            };
        }
    },
    /**
     * Straight lines with knots that lie behind the texels by a fifth of their distance (T. Blu, P. Thevenaz and M. Unser, "Linear
     * interpolation revitalized", IEEE Transactions on Image Processing 13 (2004)): as close to what was sampled as straight lines on as
     * many knots can be, where lines from sample to sample err by 2.4 times as much, and always to the same side of a bend. 4 coefficients
     * each, for means over several places.
     */
    SHIFTED_LINES("linearXyz", 0.5 * (1 - 1 / Math.sqrt(3)), 0) {
        /** Before the first sample all are as the first. */
        @Override
        void toCoefficients(float[] plane, int rows, int columns) {
            // What a sample counts in the coefficient behind it, -shift / (1 - shift), is the other filter's pole.
            forwards(plane, rows, columns, 1, (float) (1 / (1 - shift())));
        }

        @Override
        double[] weights(double t) {
            return new double[] {0, 1 - t, t, 0};
        }
    };

    /** What a sample counts in the coefficient of its neighbor falls by this factor a sample: sqrt(3) - 2. */
    static final double POLE = Math.sqrt(3) - 2;

    // POLE to this power is below the rounding of float32.
    private static final int HORIZON = 16;

    private final String shaderFunction;
    private final double shift;
    private final int marginBehind;

    Interpolation(String shaderFunction, double shift, int marginBehind) {
        this.shaderFunction = shaderFunction;
        this.shift = shift;
        this.marginBehind = marginBehind;
    }

    /** The function of shaders/include/color_table.glsl that looks colors up. */
    public String shaderFunction() {
        return shaderFunction;
    }

    /** By how many texels a coefficient lies behind its sample, along u and along v. */
    public double shift() {
        return shift;
    }

    /** Samples behind a tile that its coefficients depend on. */
    int marginBehind() {
        return marginBehind;
    }

    /**
     * Turns samples into coefficients along columns, in place, all of a row at once; beyond both ends the samples go on as in a mirror that
     * stands on the last one. Rounds to float32 at each step: 1e-7 of what lies beside it, which falls with it.
     *
     * @param plane {@code rows * columns} values; at least 9 rows
     */
    abstract void toCoefficients(float[] plane, int rows, int columns);

    /**
     * What the four coefficients around a place weigh.
     *
     * @param t the place, from the second of them on, 0..1
     */
    abstract double[] weights(double t);

    /** To each row, with its gain, what is left of the one before it. */
    private static void forwards(float[] plane, int rows, int columns, float firstGain, float gain) {
        float pole = (float) POLE;
        for (int i = 0; i < columns; i++) {
            plane[i] *= firstGain;
        }
        for (int at = columns; at < rows * columns; at += columns) {
            for (int i = 0; i < columns; i++) {
                plane[at + i] = gain * plane[at + i] + pole * plane[at - columns + i];
            }
        }
    }

    private static void addRow(float[] plane, int to, int from, float factor, int columns) {
        for (int i = 0; i < columns; i++) {
            plane[to + i] += factor * plane[from + i];
        }
    }
}
