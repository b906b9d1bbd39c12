package sunbeam.precompute.scan;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Sequential reader of numbers and texts in a file. Every method refuses to pass the end of the file. */
public final class ByteCursor {
    private static final int WINDOW = 8192;

    private final ScanBytes bytes;
    private final ByteOrder order;
    private ByteBuffer window = ByteBuffer.allocate(0);
    private long windowStart;
    private long position;

    ByteCursor(ScanBytes bytes, long position, ByteOrder order) {
        this.bytes = bytes;
        this.position = position;
        this.order = order;
    }

    public long position() {
        return position;
    }

    public ByteCursor at(long target) {
        bytes.requireInside(target, 0);
        position = target;
        return this;
    }

    public void skip(long count) {
        bytes.requireInside(position, count);
        position += count;
    }

    public int unsignedByte() throws IOException {
        return next(1).get() & 0xff;
    }

    public int int16() throws IOException {
        return next(Short.BYTES).getShort();
    }

    public int unsigned16() throws IOException {
        return int16() & 0xffff;
    }

    public int int32() throws IOException {
        return next(Integer.BYTES).getInt();
    }

    public long unsigned32() throws IOException {
        return int32() & 0xffff_ffffL;
    }

    public double float32() throws IOException {
        return next(Float.BYTES).getFloat();
    }

    public double float64() throws IOException {
        return next(Double.BYTES).getDouble();
    }

    /** Reads a Latin-1 text of {@code count} bytes: up to the first NUL, without blanks around it. */
    public String text(int count) throws IOException {
        String text = new String(bytes.read(position, count).array(), StandardCharsets.ISO_8859_1);
        position += count;
        int end = text.indexOf(0);
        return (end < 0 ? text : text.substring(0, end)).strip();
    }

    /**
     * Reads UTF-8 up to a NUL.
     *
     * @throws ScanException if the text is longer than {@code most} bytes
     */
    public String textToNul(int most) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        while (text.size() < most) {
            int next = unsignedByte();
            if (next == 0) {
                return text.toString(StandardCharsets.UTF_8);
            }
            text.write(next);
        }
        throw new ScanException(
                "has a text without end at position " + (position - most) + "; the file is damaged, export it again");
    }

    private ByteBuffer next(int count) throws IOException {
        bytes.requireInside(position, count);
        if (position < windowStart || position + count > windowStart + window.limit()) {
            windowStart = position;
            window = bytes.read(position, (int) Math.min(WINDOW, bytes.size() - position))
                    .order(order);
        }
        window.position((int) (position - windowStart));
        position += count;
        return window;
    }
}
