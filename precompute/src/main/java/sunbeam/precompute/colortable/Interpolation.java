package sunbeam.precompute.colortable;

/** How a level's colors are interpolated between its texels, in square roots of X, Y and Z. */
public enum Interpolation {
    /** By cubic B-splines through them: 16 coefficients each, right at every place. */
    CUBIC(0, LevelBaking.MARGIN) {
        @Override
        void toCoefficients(float[] plane, int rows, int columns) {
            CubicSpline.alongColumns(plane, rows, columns);
        }

        @Override
        double[] weights(double t) {
            return CubicSpline.weights(t);
        }
    },
    /**
     * By straight lines through them that are shifted against them ({@link ShiftedLinear}): 4 coefficients each, for means over several
     * places.
     */
    SHIFTED_LINES(ShiftedLinear.SHIFT, 0) {
        @Override
        void toCoefficients(float[] plane, int rows, int columns) {
            ShiftedLinear.alongColumns(plane, rows, columns);
        }

        @Override
        double[] weights(double t) {
            return new double[] {0, 1 - t, t, 0};
        }
    };

    private final double shift;
    private final int marginBehind;

    Interpolation(double shift, int marginBehind) {
        this.shift = shift;
        this.marginBehind = marginBehind;
    }

    /** By how many texels a coefficient lies behind its sample, along u and along v. */
    public double shift() {
        return shift;
    }

    /** Samples behind a tile that its coefficients depend on. */
    int marginBehind() {
        return marginBehind;
    }

    /** Turns samples into coefficients along columns, in place. */
    abstract void toCoefficients(float[] plane, int rows, int columns);

    /**
     * What the four coefficients around a place weigh.
     *
     * @param t the place, from the second of them on, 0..1
     */
    abstract double[] weights(double t);
}
