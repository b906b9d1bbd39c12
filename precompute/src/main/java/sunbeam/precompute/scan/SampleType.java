package sunbeam.precompute.scan;

import java.nio.ByteBuffer;
import java.util.Locale;

/** How a file stores one sample. */
public enum SampleType {
    UNSIGNED_8(1) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.get(i) & 0xff;
            }
        }
    },
    SIGNED_8(1) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.get(i);
            }
        }
    },
    UNSIGNED_16(Short.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getShort(Short.BYTES * i) & 0xffff;
            }
        }
    },
    SIGNED_16(Short.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getShort(Short.BYTES * i);
            }
        }
    },
    UNSIGNED_32(Integer.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getInt(Integer.BYTES * i) & 0xffff_ffffL;
            }
        }
    },
    SIGNED_32(Integer.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getInt(Integer.BYTES * i);
            }
        }
    },
    SIGNED_64(Long.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getLong(Long.BYTES * i);
            }
        }
    },
    FLOAT_32(Float.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getFloat(Float.BYTES * i);
            }
        }
    },
    FLOAT_64(Double.BYTES) {
        @Override
        void decode(ByteBuffer from, double[] to, int first, int count) {
            for (int i = 0; i < count; i++) {
                to[first + i] = from.getDouble(Double.BYTES * i);
            }
        }
    };

    private final int size;

    SampleType(int size) {
        this.size = size;
    }

    /** Bytes of a sample. */
    public int size() {
        return size;
    }

    /**
     * The signed integer of a width.
     *
     * @param bits 8, 16, 32 or 64
     * @throws ScanException for any other
     */
    public static SampleType signed(int bits) {
        return switch (bits) {
            case 8 -> SIGNED_8;
            case 16 -> SIGNED_16;
            case 32 -> SIGNED_32;
            case 64 -> SIGNED_64;
            default ->
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "stores samples of %d bits, which no reader knows; export it in another format",
                        bits));
        };
    }

    /** Decodes samples from the start of a buffer, in its byte order. */
    abstract void decode(ByteBuffer from, double[] to, int first, int count);
}
