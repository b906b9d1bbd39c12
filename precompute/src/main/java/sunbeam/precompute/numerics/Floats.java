package sunbeam.precompute.numerics;

import java.util.function.IntToDoubleFunction;

/** Arrays of numbers that are computed in double and stored in single precision. */
public final class Floats {
    private Floats() {}

    /** Returns the values at the indices 0 to count - 1, each rounded to the nearest float. */
    public static float[] of(int count, IntToDoubleFunction value) {
        float[] values = new float[count];
        for (int i = 0; i < count; i++) {
            values[i] = (float) value.applyAsDouble(i);
        }
        return values;
    }
}
