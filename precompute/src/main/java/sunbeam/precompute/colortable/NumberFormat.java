package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/** Format of a tile's coefficients in caches and on the graphics card, in native byte order. */
public enum NumberFormat {
    /** Binary16 of 256 times the root of power, to 2^-11. Powers below 6e-14 lose digits, below 5e-20 become 0. */
    HALF(Short.BYTES, 256),
    FLOAT(Float.BYTES, 1);

    private static final int SIGN = 0x8000;
    private static final int LARGEST = 0x7bff;
    // Bits of the significand that are dropped, and the difference of the exponents' biases.
    private static final int DROPPED_BITS = 13;
    private static final int ROUNDING = (1 << (DROPPED_BITS - 1)) - 1;
    private static final int EXPONENTS_APART = (127 - 15) << 23;
    // Smallest normal binary16 as binary32 and as binary16, smallest binary16, power of two beyond the largest one.
    private static final int LEAST_NORMAL_BITS = (127 - 14) << 23;
    private static final int LEAST_NORMAL_HALF = 1 << 10;
    private static final float LEAST_HALF = 0x1p-24f;
    private static final int BEYOND_BITS = (127 + 16) << 23;
    // Its unit in the last place is the smallest binary16: adding it rounds smaller floats to multiples of it.
    private static final float LEAST_SCALE = 0.5f;

    private final int bytes;
    private final int scale;

    NumberFormat(int bytes, int scale) {
        this.bytes = bytes;
        this.scale = scale;
    }

    public int bytes() {
        return bytes;
    }

    public int scale() {
        return scale;
    }

    byte[] encoded(float[] values) {
        ByteBuffer encoded = ByteBuffer.allocate(values.length * bytes).order(ByteOrder.nativeOrder());
        for (float value : values) {
            if (this == HALF) {
                encoded.putShort(half(scale * value));
            } else {
                encoded.putFloat(value);
            }
        }
        return encoded.array();
    }

    /** Decodes all values, without dividing by {@link #scale()}. */
    FloatBuffer floats(ByteBuffer encoded) {
        if (this == FLOAT) {
            return encoded.asFloatBuffer();
        }
        float[] floats = new float[encoded.capacity() / bytes];
        for (int i = 0; i < floats.length; i++) {
            floats[i] = decoded(encoded, i);
        }
        return FloatBuffer.wrap(floats);
    }

    float decoded(ByteBuffer encoded, int index) {
        return this == HALF ? ofHalf(encoded.getShort(index * bytes)) : encoded.getFloat(index * bytes);
    }

    public static float ofHalf(short bits) {
        int magnitude = bits & Short.MAX_VALUE;
        float value = magnitude < LEAST_NORMAL_HALF
                ? magnitude * LEAST_HALF
                : Float.intBitsToFloat((magnitude << DROPPED_BITS) + EXPONENTS_APART);
        return (bits & SIGN) == 0 ? value : -value;
    }

    /** Returns the nearest binary16, ties to even; beyond its range the largest finite one. */
    public static short half(float value) {
        int bits = Float.floatToRawIntBits(value);
        int sign = (bits >>> Short.SIZE) & SIGN;
        int magnitude = bits & Integer.MAX_VALUE;
        if (magnitude < LEAST_NORMAL_BITS) {
            float shifted = Float.intBitsToFloat(magnitude) + LEAST_SCALE;
            return (short) (sign | (Float.floatToRawIntBits(shifted) - Float.floatToRawIntBits(LEAST_SCALE)));
        }
        int even = (magnitude >>> DROPPED_BITS) & 1;
        int rounded = (magnitude - EXPONENTS_APART + ROUNDING + even) >>> DROPPED_BITS;
        return (short) (sign | (magnitude < BEYOND_BITS ? Math.min(rounded, LARGEST) : LARGEST));
    }
}
