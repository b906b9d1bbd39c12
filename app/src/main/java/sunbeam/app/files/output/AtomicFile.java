package sunbeam.app.files.output;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import sunbeam.app.terminal.CancelledException;
import sunbeam.app.terminal.ShutdownHook;

/**
 * An output file that appears whole or not at all. It is written beside its target under a temporary name, forced to
 * the disk and renamed; a failure, {@link #close} without {@link #commit}, or the end of the process (Ctrl-C) removes
 * it. A target that is a device or a pipe ({@code /dev/null}) is written directly.
 */
public final class AtomicFile implements AutoCloseable {
    private static final int BUFFER_BYTES = 1 << 16;
    /** One block of usual file systems: a full disk refuses it. */
    private static final int PROBE_BYTES = 4096;

    private enum State {
        OPEN,
        COMMITTED,
        CLOSED
    }

    private final Path target;
    private final Overwrite overwrite;
    private final boolean direct;
    private final ShutdownHook hook;
    private Path written;
    private State state = State.OPEN;

    private AtomicFile(Path target, Overwrite overwrite) {
        this.target = target;
        this.overwrite = overwrite;
        this.direct = isDevice(target);
        this.written = target;
        hook = new ShutdownHook(this::discard);
    }

    /** Writes a file's bytes to a stream. */
    @FunctionalInterface
    public interface StreamContent {
        void writeTo(OutputStream stream) throws IOException;
    }

    /** Writes a file that exists and is empty. */
    @FunctionalInterface
    public interface FileContent {
        void writeTo(Path file) throws IOException;
    }

    /**
     * Tells early, before a long computation, whether the target could be written now: the folder takes a file, the
     * disk has room for a block, nothing stands in the way. Leaves nothing behind.
     *
     * @throws OutputException when it could not
     */
    public static void checkWritable(Path target, Overwrite overwrite) {
        try (AtomicFile probe = create(target, overwrite)) {
            if (!probe.direct) {
                Files.write(probe.path(), new byte[PROBE_BYTES]);
            }
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    /** Writes the whole target through a buffered stream; an {@link IOException} of the content is the target's. */
    public static void write(Path target, Overwrite overwrite, StreamContent content) {
        try (AtomicFile file = create(target, overwrite)) {
            file.fill(content);
            file.commit();
        }
    }

    /** As {@link #write}, for libraries that open the file themselves. */
    public static void writeFile(Path target, Overwrite overwrite, FileContent content) {
        try (AtomicFile file = create(target, overwrite)) {
            content.writeTo(file.path());
            file.commit();
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        } catch (UncheckedIOException failure) {
            throw OutputException.of(target, failure.getCause());
        }
    }

    /**
     * Starts a file.
     *
     * @throws OutputException when the target is a folder, exists and may not be replaced, or its folder is missing or
     *     takes no file
     */
    public static AtomicFile create(Path target, Overwrite overwrite) {
        checkTarget(target, overwrite);
        try {
            AtomicFile file = new AtomicFile(resolveLink(target), overwrite);
            file.begin();
            return file;
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    /** Apart from the constructor, so that the shutdown hook sees either no temporary file or its name. */
    private synchronized void begin() throws IOException {
        if (state != State.OPEN) {
            throw new CancelledException();
        }
        if (direct) {
            return;
        }
        try {
            written = createTemporary(folderOf(target));
        } catch (IOException failure) {
            state = State.CLOSED;
            hook.close();
            throw failure;
        }
    }

    /**
     * Writes the content, which does not appear before {@link #commit}.
     *
     * @throws OutputException when it cannot be written, also when the content throws an {@link IOException}
     */
    public void fill(StreamContent content) {
        try (OutputStream stream = new BufferedOutputStream(Files.newOutputStream(path()), BUFFER_BYTES)) {
            content.writeTo(stream);
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        } catch (UncheckedIOException failure) {
            throw OutputException.of(target, failure.getCause());
        }
    }

    /** Where to write the content. Writers must have closed it before {@link #commit}. */
    public synchronized Path path() {
        return written;
    }

    /**
     * Makes the content appear under the target's name.
     *
     * @throws OutputException when that fails, also because a file has appeared there meanwhile
     * @throws CancelledException when the process is being ended
     */
    public synchronized void commit() {
        if (state == State.COMMITTED) {
            throw new IllegalStateException(target + " was committed before");
        }
        if (state == State.CLOSED) {
            throw new CancelledException();
        }
        try {
            if (!direct) {
                force(written);
                rename();
            }
            state = State.COMMITTED;
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    /** Removes what was written, unless it was committed. */
    @Override
    public void close() {
        discard();
        hook.close();
    }

    private synchronized void discard() {
        if (state != State.OPEN) {
            return;
        }
        state = State.CLOSED;
        if (written.equals(target)) {
            return;
        }
        try {
            Files.deleteIfExists(written);
        } catch (IOException failure) {
            throw new OutputException("cannot remove the temporary file " + written + "; remove it by hand", failure);
        }
    }

    private void rename() throws IOException {
        if (overwrite == Overwrite.REPLACE) {
            Files.move(written, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } else {
            Files.move(written, target);
        }
    }

    private static void force(Path file) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            channel.force(true);
        }
    }

    private static void checkTarget(Path target, Overwrite overwrite) {
        if (Files.isDirectory(target)) {
            throw new OutputException("cannot write " + target + ": it is a folder; name a file in it");
        }
        Path folder = folderOf(target);
        if (!Files.exists(folder)) {
            throw new OutputException(
                    "cannot write " + target + ": the folder " + folder + " does not exist; create it first");
        }
        if (!Files.isDirectory(folder)) {
            throw new OutputException("cannot write " + target + ": " + folder + " is not a folder");
        }
        if (!Files.exists(target, LinkOption.NOFOLLOW_LINKS) || isDevice(target)) {
            return;
        }
        if (overwrite == Overwrite.REFUSE) {
            throw OutputException.of(target, new FileAlreadyExistsException(target.toString()));
        }
        if (!Files.isWritable(target)) {
            throw new OutputException("cannot write " + target + ": it is write-protected; choose another name");
        }
    }

    /** Renaming onto a symbolic link would replace the link: go to the file that it stands for. */
    private static Path resolveLink(Path target) throws IOException {
        return Files.isSymbolicLink(target) && Files.isRegularFile(target) ? target.toRealPath() : target;
    }

    private static boolean isDevice(Path target) {
        return Files.exists(target) && !Files.isRegularFile(target) && !Files.isDirectory(target);
    }

    private static Path folderOf(Path target) {
        Path folder = target.toAbsolutePath().getParent();
        return folder != null ? folder : target.toAbsolutePath();
    }

    /** Not Files.createTempFile: that makes files which only their owner may read, and they are the output later. */
    private static Path createTemporary(Path folder) throws IOException {
        long process = ProcessHandle.current().pid();
        for (int number = 0; ; number++) {
            Path candidate = folder.resolve(".sunbeam-" + process + "-" + number + ".part");
            try {
                return Files.createFile(candidate);
            } catch (FileAlreadyExistsException taken) {
                // Another output of this process, or left by one that was killed: take the next number.
            }
        }
    }
}
