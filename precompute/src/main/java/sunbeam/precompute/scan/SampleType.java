package sunbeam.precompute.scan;

import java.nio.ByteBuffer;
import java.util.Locale;

/** How a file stores one sample. */
@SuppressWarnings("ImmutableEnumChecker") // functions of nothing but their arguments
public enum SampleType {
    UNSIGNED_8(1, (from, at) -> from.get(at) & 0xff),
    SIGNED_8(1, ByteBuffer::get),
    UNSIGNED_16(Short.BYTES, (from, at) -> from.getShort(at) & 0xffff),
    SIGNED_16(Short.BYTES, ByteBuffer::getShort),
    UNSIGNED_32(Integer.BYTES, (from, at) -> from.getInt(at) & 0xffff_ffffL),
    SIGNED_32(Integer.BYTES, ByteBuffer::getInt),
    SIGNED_64(Long.BYTES, ByteBuffer::getLong),
    FLOAT_32(Float.BYTES, ByteBuffer::getFloat),
    FLOAT_64(Double.BYTES, ByteBuffer::getDouble);

    private final int size;
    private final Decoder decoder;

    /** Of one sample at a byte of a buffer, in its order. */
    @FunctionalInterface
    private interface Decoder {
        double decode(ByteBuffer from, int at);
    }

    SampleType(int size, Decoder decoder) {
        this.size = size;
        this.decoder = decoder;
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
    void decode(ByteBuffer from, double[] to, int first, int count) {
        for (int i = 0; i < count; i++) {
            to[first + i] = decoder.decode(from, size * i);
        }
    }
}
