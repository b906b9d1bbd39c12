package sunbeam.app.cli.export;

import java.nio.file.Path;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.UsageException;

/** Limit of an output's size: {@code most} bytes on disk, and a fraction of Java's heap in memory. */
record OutputLimit(TableWriter writer, Path output, long most) {
    // A table may take this fraction of Java's heap; a writer needs as much again for its copy.
    private static final int HEAP_SHARE = 3;

    void requireRoom() {
        requireRoom(most);
    }

    private void requireRoom(long bytes) {
        AtomicFile.requireRoom(output, bytes, "it may take", "give a --size that is less");
    }

    /** True if a table of this shape may fit on disk and in memory, by a lower bound of its size before it is computed. */
    boolean mayHold(GridShape shape) {
        long bytes = writer.leastBytes(shape);
        if (bytes <= most) {
            requireRoom(bytes);
        }
        long numbers = writer.numbers(shape);
        return bytes <= most
                && numbers < Integer.MAX_VALUE
                && numbers * Float.BYTES < Runtime.getRuntime().maxMemory() / HEAP_SHARE;
    }

    boolean holds(ColorGrid grid) {
        return writer.bytes(grid) <= most;
    }

    UsageException refusal(GridShape coarsest) {
        long bytes = writer.leastBytes(coarsest);
        return new UsageException(
                bytes <= most
                        ? "--size " + ByteSize.format(most) + " or Java's memory holds no table of this surface;"
                                + " give more of it (memory by SUNBEAM_JAVA_OPTIONS=-Xmx8g)"
                        : "--size " + ByteSize.format(most) + " holds no table of this surface: that of the widest"
                                + " orders takes " + ByteSize.format(bytes) + "; give more");
    }
}
