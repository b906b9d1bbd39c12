package sunbeam.precompute.scan;

import com.twelvemonkeys.imageio.metadata.tiff.Half;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Binary format of one sample. */
@SuppressWarnings("ImmutableEnumChecker") // the decoders have no state
public enum SampleType {
    UNSIGNED_8(1, (from, at) -> from.get(at) & 0xff),
    SIGNED_8(1, ByteBuffer::get),
    UNSIGNED_16(Short.BYTES, (from, at) -> from.getShort(at) & 0xffff),
    SIGNED_16(Short.BYTES, ByteBuffer::getShort),
    UNSIGNED_32(Integer.BYTES, (from, at) -> from.getInt(at) & 0xffff_ffffL),
    SIGNED_32(Integer.BYTES, ByteBuffer::getInt),
    SIGNED_64(Long.BYTES, ByteBuffer::getLong),
    FLOAT_16(Short.BYTES, (from, at) -> Half.shortBitsToFloat(from.getShort(at))),
    FLOAT_32(Float.BYTES, ByteBuffer::getFloat),
    FLOAT_64(Double.BYTES, ByteBuffer::getDouble);

    private static final int BUFFER_SAMPLES = 1 << 15;

    private final int size;
    private final Decoder decoder;

    @FunctionalInterface
    private interface Decoder {
        double decode(ByteBuffer from, int at);
    }

    SampleType(int size, Decoder decoder) {
        this.size = size;
        this.decoder = decoder;
    }

    public int size() {
        return size;
    }

    /** Decodes the sample at a byte offset, in the buffer's byte order. */
    public double decode(ByteBuffer from, int at) {
        return decoder.decode(from, at);
    }

    /** Throws ScanException unless the width is 8, 16, 32 or 64 bits. */
    public static SampleType signed(int bits) {
        return Stream.of(values())
                .filter(type -> type.name().equals("SIGNED_" + bits))
                .findFirst()
                .orElseThrow(() -> new ScanException(
                        "stores samples of " + bits + " bits, which no reader knows; export it in another format"));
    }

    /** Finds a type by its kind, such as SIGNED, and the decimal number of its bytes. */
    public static Optional<SampleType> find(String kind, String bytes) {
        return Stream.of(values())
                .filter(type -> type.name().startsWith(kind + "_") && bytes.equals(String.valueOf(type.size)))
                .findFirst();
    }

    public static SampleType of(Map<?, SampleType> types, Object code) {
        SampleType type = types.get(code);
        ScanException.refuseIf(
                type == null, "stores samples of the unknown type " + code + "; export it in another format");
        return type;
    }

    /** Throws ScanException if the stream ends too early. */
    public double[] read(InputStream in, int count, ByteOrder order) throws IOException {
        double[] samples = new double[count];
        byte[] bytes = new byte[BUFFER_SAMPLES * size];
        ByteBuffer buffer = ByteBuffer.wrap(bytes).order(order);
        for (int first = 0; first < count; first += BUFFER_SAMPLES) {
            int wanted = Math.min(BUFFER_SAMPLES, count - first);
            if (in.readNBytes(bytes, 0, wanted * size) < wanted * size) {
                throw new ScanException("ends before the last of its " + count + " samples; copy or export it again");
            }
            for (int i = 0; i < wanted; i++) {
                samples[first + i] = decoder.decode(buffer, size * i);
            }
        }
        return samples;
    }
}
