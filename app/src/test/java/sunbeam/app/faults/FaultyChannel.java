package sunbeam.app.faults;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.WritableByteChannel;

/** A channel whose calls fail when they are told to; a write that fails has written half. */
final class FaultyChannel extends FileChannel {
    private final FileChannel inner;
    private final Faults faults;

    FaultyChannel(FileChannel inner, Faults faults) {
        this.inner = inner;
        this.faults = faults;
    }

    private static ByteBuffer half(ByteBuffer source) {
        return source.slice(source.position(), source.remaining() / 2);
    }

    @Override
    public int write(ByteBuffer source) throws IOException {
        if (faults.isNext()) {
            inner.write(half(source));
        }
        faults.beforeCall("write");
        return inner.write(source);
    }

    @Override
    public int write(ByteBuffer source, long position) throws IOException {
        if (faults.isNext()) {
            inner.write(half(source), position);
        }
        faults.beforeCall("write");
        return inner.write(source, position);
    }

    @Override
    public long write(ByteBuffer[] sources, int offset, int length) throws IOException {
        faults.beforeCall("write");
        return inner.write(sources, offset, length);
    }

    @Override
    public int read(ByteBuffer target) throws IOException {
        faults.beforeCall("read");
        return inner.read(target);
    }

    @Override
    public int read(ByteBuffer target, long position) throws IOException {
        faults.beforeCall("read");
        return inner.read(target, position);
    }

    @Override
    public long read(ByteBuffer[] targets, int offset, int length) throws IOException {
        faults.beforeCall("read");
        return inner.read(targets, offset, length);
    }

    @Override
    public long position() throws IOException {
        return inner.position();
    }

    @Override
    public FileChannel position(long position) throws IOException {
        inner.position(position);
        return this;
    }

    @Override
    public long size() throws IOException {
        return inner.size();
    }

    @Override
    public FileChannel truncate(long size) throws IOException {
        faults.beforeCall("truncate");
        inner.truncate(size);
        return this;
    }

    @Override
    public void force(boolean metaData) throws IOException {
        faults.beforeCall("force");
        inner.force(metaData);
    }

    @Override
    public long transferTo(long position, long count, WritableByteChannel target) throws IOException {
        faults.beforeCall("transfer");
        return inner.transferTo(position, count, target);
    }

    @Override
    public long transferFrom(ReadableByteChannel source, long position, long count) throws IOException {
        faults.beforeCall("transfer");
        return inner.transferFrom(source, position, count);
    }

    @Override
    public MappedByteBuffer map(MapMode mode, long position, long size) throws IOException {
        faults.beforeCall("map");
        return inner.map(mode, position, size);
    }

    @Override
    public FileLock lock(long position, long size, boolean shared) throws IOException {
        return inner.lock(position, size, shared);
    }

    @Override
    public FileLock tryLock(long position, long size, boolean shared) throws IOException {
        return inner.tryLock(position, size, shared);
    }

    @Override
    protected void implCloseChannel() throws IOException {
        inner.close();
        faults.beforeCall("close");
    }
}
