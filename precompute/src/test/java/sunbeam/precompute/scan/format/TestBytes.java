package sunbeam.precompute.scan.format;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Bytes composed in one byte order. */
final class TestBytes {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteOrder order;

    TestBytes(ByteOrder order) {
        this.order = order;
    }

    static TestBytes little() {
        return new TestBytes(ByteOrder.LITTLE_ENDIAN);
    }

    static TestBytes big() {
        return new TestBytes(ByteOrder.BIG_ENDIAN);
    }

    TestBytes bytes(byte... bytes) {
        out.writeBytes(bytes);
        return this;
    }

    TestBytes int8(int value) {
        return bytes((byte) value);
    }

    TestBytes int16(int value) {
        return bytes(ByteBuffer.allocate(2).order(order).putShort((short) value).array());
    }

    TestBytes int32(int value) {
        return bytes(ByteBuffer.allocate(4).order(order).putInt(value).array());
    }

    TestBytes float32(double value) {
        return bytes(ByteBuffer.allocate(4).order(order).putFloat((float) value).array());
    }

    TestBytes float64(double value) {
        return bytes(ByteBuffer.allocate(8).order(order).putDouble(value).array());
    }

    /** Empty, in the same order. */
    TestBytes fresh() {
        return new TestBytes(order);
    }

    boolean isLittle() {
        return order == ByteOrder.LITTLE_ENDIAN;
    }

    /** Latin-1. */
    TestBytes text(String text) {
        return bytes(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Latin-1 with NULs, or blanks, up to a length. */
    TestBytes text(String text, int length, char filling) {
        text(text);
        for (int i = text.length(); i < length; i++) {
            int8(filling);
        }
        return this;
    }

    TestBytes utf16(String text, int characters) {
        byte[] bytes =
                text.getBytes(order == ByteOrder.BIG_ENDIAN ? StandardCharsets.UTF_16BE : StandardCharsets.UTF_16LE);
        return bytes(bytes).zeros(2 * characters - bytes.length);
    }

    TestBytes zeros(int count) {
        return bytes(new byte[count]);
    }

    TestBytes zerosUpTo(int length) {
        return zeros(length - size());
    }

    int size() {
        return out.size();
    }

    byte[] array() {
        return out.toByteArray();
    }
}
