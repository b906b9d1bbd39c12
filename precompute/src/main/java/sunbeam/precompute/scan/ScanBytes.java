package sunbeam.precompute.scan;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.stream.Stream;

/** Random access to the bytes of a file. Reads beyond its end are refused before memory is taken. */
public record ScanBytes(Path path, FileChannel channel, long size) implements AutoCloseable {
    /** Bytes, since a header is read at once; the longest known has 100 KB. */
    public static final int LARGEST_HEADER = 1 << 24;

    private static final int STREAM_BUFFER = 1 << 18;
    // Bytes by which a format is known.
    private static final int LONGEST_MARK = 64;

    public static ScanBytes open(Path path) throws IOException {
        FileChannel channel = FileChannel.open(path, StandardOpenOption.READ);
        try {
            return new ScanBytes(path, channel, channel.size());
        } catch (IOException failure) {
            channel.close();
            throw failure;
        }
    }

    public byte[] head(int count) throws IOException {
        return read(0, (int) Math.min(count, size)).array();
    }

    public boolean startsWith(String... texts) throws IOException {
        return Stream.of(texts).anyMatch(headText(LONGEST_MARK)::startsWith);
    }

    /** Returns the Latin-1 text before a mark in the first {@link Header#LARGEST} bytes. */
    public String headBefore(String mark) throws IOException {
        String head = headText(Header.LARGEST);
        int end = head.indexOf(mark);
        ScanException.refuseIf(
                end < 0, "has no " + (mark.equals("\0") ? "NUL" : mark) + " after its header; copy or export it again");
        return head.substring(0, end);
    }

    public String headText(int count) throws IOException {
        return new String(head(count), StandardCharsets.ISO_8859_1);
    }

    /** Reads bytes of a header, at most {@link #LARGEST_HEADER}, into a big-endian buffer with an array of exactly these. */
    public ByteBuffer read(long offset, int count) throws IOException {
        requireInside(offset, count);
        ScanException.refuseIf(
                count > LARGEST_HEADER, "claims a header of " + count + " bytes; the file is damaged, export it again");
        ByteBuffer buffer = ByteBuffer.allocate(count);
        while (buffer.hasRemaining()) {
            if (channel.read(buffer, offset + buffer.position()) < 0) {
                throw new ScanException("became shorter while it was read; copy it to another folder");
            }
        }
        return buffer.flip();
    }

    public void requireInside(long offset, long count) {
        if (offset < 0 || count < 0 || offset > Long.MAX_VALUE - count) {
            throw new ScanException(
                    "claims " + count + " bytes at position " + offset + "; the file is damaged, export it again");
        }
        if (offset + count > size) {
            throw new ScanException("ends after " + size + " bytes, but what its header promises takes "
                    + (offset + count) + "; copy or export it again");
        }
    }

    public Cursor cursor(long offset, ByteOrder order) {
        return new Cursor(offset, order);
    }

    /** Opens a stream from a position, valid until the next call, which moves the same file channel. */
    public InputStream stream(long offset) throws IOException {
        requireInside(offset, 0);
        channel.position(offset);
        return new BufferedInputStream(Channels.newInputStream(channel), STREAM_BUFFER);
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }

    /** Sequential reader, which refuses to pass the end of the file. */
    public final class Cursor {
        private static final int WINDOW = 8192;

        private final ByteOrder order;
        private ByteBuffer window = ByteBuffer.allocate(0);
        private long windowStart;
        private long position;

        private Cursor(long position, ByteOrder order) {
            this.position = position;
            this.order = order;
        }

        public long position() {
            return position;
        }

        public Cursor at(long target) {
            requireInside(target, 0);
            position = target;
            return this;
        }

        public void skip(long count) {
            requireInside(position, count);
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

        public long int64() throws IOException {
            return next(Long.BYTES).getLong();
        }

        public double float32() throws IOException {
            return next(Float.BYTES).getFloat();
        }

        public double float64() throws IOException {
            return next(Double.BYTES).getDouble();
        }

        /** Reads Latin-1 of {@code count} bytes: up to the first NUL, stripped. */
        public String text(int count) throws IOException {
            String text = new String(ScanBytes.this.read(position, count).array(), StandardCharsets.ISO_8859_1);
            position += count;
            return text.split("\0", 2)[0].strip();
        }

        /** Reads UTF-8 up to a NUL, at most {@code most} bytes. */
        public String textToNul(int most) throws IOException {
            ByteArrayOutputStream text = new ByteArrayOutputStream();
            while (text.size() < most) {
                int next = unsignedByte();
                if (next == 0) {
                    return text.toString(StandardCharsets.UTF_8);
                }
                text.write(next);
            }
            throw new ScanException("has a text without end at position " + (position - most)
                    + "; the file is damaged, export it again");
        }

        private ByteBuffer next(int count) throws IOException {
            requireInside(position, count);
            if (position < windowStart || position + count > windowStart + window.limit()) {
                windowStart = position;
                window = ScanBytes.this
                        .read(position, (int) Math.min(WINDOW, size - position))
                        .order(order);
            }
            window.position((int) (position - windowStart));
            position += count;
            return window;
        }
    }
}
