package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/** Numbers that a tile's coefficients are kept and uploaded as, in the processor's order of bytes. */
public enum NumberFormat {
    /**
     * IEEE 754's binary16, times 256: a root of a color errs by no more than 2^-11 of it. A flat mirror's is about 1, and what prefilters make of
     * it no more than 9; of powers below 4e-14 digits go, below 5e-20 all.
     */
    HALF(Short.BYTES, 256) {
        @Override
        void put(float[] values, ByteBuffer bytes) {
            short[] halves = new short[values.length];
            for (int i = 0; i < values.length; i++) {
                halves[i] = half(256 * values[i]);
            }
            bytes.asShortBuffer().put(halves);
        }

        @Override
        float decoded(ByteBuffer encoded, int index) {
            return ofHalf(encoded.getShort(index * Short.BYTES));
        }
    },
    /** IEEE 754's binary32. */
    FLOAT(Float.BYTES, 1) {
        @Override
        void put(float[] values, ByteBuffer bytes) {
            bytes.asFloatBuffer().put(values);
        }

        @Override
        float decoded(ByteBuffer encoded, int index) {
            return encoded.getFloat(index * Float.BYTES);
        }
    };

    private static final int SIGN = 0x8000;
    private static final int LARGEST = 0x7bff;
    private static final int DROPPED_BITS = 13;
    private static final int ROUNDING = (1 << (DROPPED_BITS - 1)) - 1;
    private static final int EXPONENTS_APART = (127 - 15) << 23;
    private static final int LEAST_NORMAL_BITS = (127 - 14) << 23;
    private static final int LEAST_NORMAL_HALF = 1 << 10;
    private static final float LEAST_HALF = 0x1p-24f;
    private static final int BEYOND_BITS = (127 + 16) << 23;
    // A float whose last bit counts as much as the smallest binary16.
    private static final float LEAST_SCALE = 0.5f;

    private final int bytes;
    private final int scale;

    NumberFormat(int bytes, int scale) {
        this.bytes = bytes;
        this.scale = scale;
    }

    /** Bytes of one. */
    public int bytes() {
        return bytes;
    }

    /** What a coefficient is multiplied by. */
    public int scale() {
        return scale;
    }

    /** Of some values. */
    byte[] encoded(float[] values) {
        byte[] encoded = new byte[values.length * bytes];
        put(values, ByteBuffer.wrap(encoded).order(ByteOrder.nativeOrder()));
        return encoded;
    }

    /** All of some encoded values, times {@link #scale()} as they are. */
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

    abstract void put(float[] values, ByteBuffer target);

    /** One of encoded values, times {@link #scale()} as it is. */
    abstract float decoded(ByteBuffer encoded, int index);

    /** The value of a binary16 that is finite. */
    public static float ofHalf(short bits) {
        int magnitude = bits & Short.MAX_VALUE;
        float value = magnitude < LEAST_NORMAL_HALF
                ? magnitude * LEAST_HALF
                : Float.intBitsToFloat((magnitude << DROPPED_BITS) + EXPONENTS_APART);
        return (bits & SIGN) == 0 ? value : -value;
    }

    /** Bits of the nearest binary16, the even one of two; what is larger than all becomes the largest. */
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
