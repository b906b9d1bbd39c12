package sunbeam.precompute.colortable;

import java.util.Arrays;
import sunbeam.precompute.numerics.SplineFilter;

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
            SplineFilter.alongColumns(plane, rows, columns, SplineFilter.CUBIC);
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
            float pole = (float) (-shift() / (1 - shift()));
            float gain = (float) (1 / (1 - shift()));
            for (int at = columns; at < rows * columns; at += columns) {
                for (int i = 0; i < columns; i++) {
                    plane[at + i] = gain * plane[at + i] + pole * plane[at - columns + i];
                }
            }
        }

        @Override
        double[] weights(double t) {
            return new double[] {0, 1 - t, t, 0};
        }
    };

    // Enough for a spline's prefilter.
    private static final int KEY_SAMPLES = 16;

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

    /**
     * The filter's content for keys of caches: its name, and the coefficients of a single sample of 1. A filter that changes
     * under its name has another key.
     */
    public String key() {
        float[] impulse = new float[KEY_SAMPLES];
        impulse[KEY_SAMPLES / 2] = 1;
        toCoefficients(impulse, KEY_SAMPLES, 1);
        return name() + " shifted by " + shift + " of " + Arrays.toString(impulse);
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
     * Turns samples into coefficients along columns, in place.
     *
     * @param plane {@code rows * columns} values; at least 11 rows of splines
     */
    abstract void toCoefficients(float[] plane, int rows, int columns);

    /**
     * What the four coefficients around a place weigh.
     *
     * @param t the place, from the second of them on, 0..1
     */
    abstract double[] weights(double t);
}
