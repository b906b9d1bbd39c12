package sunbeam.precompute.scan.format;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import sunbeam.precompute.scan.ScanException;

/** A stream that complains when more is read of it than there should be: what unpacks to terabytes is not unpacked. */
final class BoundedStream extends FilterInputStream {
    private long rest;

    /** @param most bytes */
    BoundedStream(InputStream in, long most) {
        super(in);
        rest = most;
    }

    @Override
    public int read() throws IOException {
        int value = in.read();
        count(value < 0 ? 0 : 1);
        return value;
    }

    @Override
    public int read(byte[] bytes, int offset, int length) throws IOException {
        int read = in.read(bytes, offset, length);
        count(Math.max(0, read));
        return read;
    }

    private void count(int bytes) {
        rest -= bytes;
        if (rest < 0) {
            throw new ScanException("unpacks to far more than a scan's header has; export it again");
        }
    }
}
