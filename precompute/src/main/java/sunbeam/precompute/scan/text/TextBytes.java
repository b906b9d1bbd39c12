package sunbeam.precompute.scan.text;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import sunbeam.precompute.scan.ScanBytes;

/**
 * A text with one byte a character: the file's own, or those of what Windows calls Unicode, UTF-16 with a byte order mark,
 * as Latin-1, which has all that numbers and units need.
 */
final class TextBytes {
    private static final int LATIN = 0x100;
    private static final int GREEK_MU = 0x3bc;
    private static final int MICRO_SIGN = 0xb5;

    private final ScanBytes file;
    /** Bytes of the mark, whose characters have two each; 0 where they have one. */
    private final int mark;

    private final boolean littleEndian;

    private TextBytes(ScanBytes file, int mark, boolean littleEndian) {
        this.file = file;
        this.mark = mark;
        this.littleEndian = littleEndian;
    }

    static TextBytes of(ScanBytes file) throws IOException {
        byte[] head = file.head(2);
        boolean little = head.length == 2 && head[0] == (byte) 0xff && head[1] == (byte) 0xfe;
        boolean big = head.length == 2 && head[0] == (byte) 0xfe && head[1] == (byte) 0xff;
        return new TextBytes(file, little || big ? 2 : 0, little);
    }

    /** Characters. */
    long size() {
        return mark == 0 ? file.size() : (file.size() - mark) / 2;
    }

    /** The first characters, as many as asked for or as there are. */
    byte[] head(int count) throws IOException {
        if (mark == 0) {
            return file.head(count);
        }
        byte[] wide = file.head(mark + 2 * count);
        try (InputStream narrow = new Narrow(new ByteArrayInputStream(wide, mark, wide.length - mark), littleEndian)) {
            return narrow.readAllBytes();
        }
    }

    /** Everything from a character on. */
    InputStream stream(long offset) throws IOException {
        return mark == 0 ? file.stream(offset) : new Narrow(file.stream(mark + 2 * offset), littleEndian);
    }

    /** One byte of each two; half a character at the end is none. */
    private static final class Narrow extends InputStream {
        private final InputStream wide;
        private final boolean littleEndian;

        Narrow(InputStream wide, boolean littleEndian) {
            this.wide = wide;
            this.littleEndian = littleEndian;
        }

        @Override
        public int read() throws IOException {
            int first = wide.read();
            int second = wide.read();
            if (second < 0) {
                return -1;
            }
            int character = littleEndian ? first | (second << 8) : (first << 8) | second;
            if (character == GREEK_MU) {
                return MICRO_SIGN;
            }
            return character < LATIN ? character : '?';
        }

        @Override
        public int read(byte[] target, int offset, int length) throws IOException {
            int count = 0;
            int next = length > 0 ? read() : -1;
            while (next >= 0) {
                target[offset + count++] = (byte) next;
                next = count < length ? read() : -1;
            }
            return count == 0 && length > 0 ? -1 : count;
        }

        @Override
        public void close() throws IOException {
            wide.close();
        }
    }
}
