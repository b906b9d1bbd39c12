package sunbeam.precompute.scan;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Random access to the bytes of a file. Reads beyond its end are refused before memory is taken. */
public record ScanBytes(Path path, FileChannel channel, long size) implements AutoCloseable {
    /** Bytes, since a header is read at once; the longest known has 100 KB. */
    public static final int LARGEST_HEADER = 1 << 24;

    private static final int STREAM_BUFFER = 1 << 18;

    public static ScanBytes open(Path path) throws IOException {
        FileChannel channel = FileChannel.open(path, StandardOpenOption.READ);
        try {
            return new ScanBytes(path, channel, channel.size());
        } catch (IOException failure) {
            channel.close();
            throw failure;
        }
    }

    /** Returns the first bytes, at most {@code count}. */
    public byte[] head(int count) throws IOException {
        return read(0, (int) Math.min(count, size)).array();
    }

    /** True if the file begins with one of the given Latin-1 texts. */
    public boolean startsWith(String... texts) throws IOException {
        for (String text : texts) {
            if (headText(text.length()).equals(text)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns the Latin-1 text from the start of the file to a mark.
     *
     * @throws ScanException if there is no mark in the first {@link Header#LARGEST} bytes
     */
    public String headBefore(String mark) throws IOException {
        String head = headText(Header.LARGEST);
        int end = head.indexOf(mark);
        if (end < 0) {
            throw new ScanException(
                    "has no " + (mark.equals("\0") ? "NUL" : mark) + " after its header; copy or export it again");
        }
        return head.substring(0, end);
    }

    /** Returns the first bytes as Latin-1 text, at most {@code count}. */
    public String headText(int count) throws IOException {
        return new String(head(count), StandardCharsets.ISO_8859_1);
    }

    /**
     * Reads bytes of a header into a big-endian buffer, backed by an array of exactly these bytes.
     *
     * @throws ScanException if the file has fewer bytes, or they are too many for a header
     */
    public ByteBuffer read(long offset, int count) throws IOException {
        requireInside(offset, count);
        if (count > LARGEST_HEADER) {
            throw new ScanException("claims a header of " + count + " bytes; the file is damaged, export it again");
        }
        ByteBuffer buffer = ByteBuffer.allocate(count);
        while (buffer.hasRemaining()) {
            if (channel.read(buffer, offset + buffer.position()) < 0) {
                throw new ScanException("became shorter while it was read; copy it to another folder");
            }
        }
        return buffer.flip();
    }

    /** Refuses a range outside the file. */
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

    public ByteCursor cursor(long offset, ByteOrder order) {
        return new ByteCursor(this, offset, order);
    }

    /** Opens a stream from a position to the end, valid until the next call, which moves the same file channel. */
    public InputStream stream(long offset) throws IOException {
        requireInside(offset, 0);
        channel.position(offset);
        return new BufferedInputStream(Channels.newInputStream(channel), STREAM_BUFFER);
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
