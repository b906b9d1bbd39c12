package sunbeam.app.files.output;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import sunbeam.app.terminal.CancelledException;
import sunbeam.app.terminal.ShutdownHook;

/**
 * An output file that appears whole or not at all. It is written beside its target under a temporary name, forced to
 * the disk and renamed; a failure, {@link #close} without {@link #commit}, or the end of the process (Ctrl-C) removes
 * it. A symbolic link in the target's place is replaced; the file that it stands for stays. A target that is a device or a pipe
 * ({@code /dev/null}) is written directly; {@code -} is standard output, which gets the whole content at once.
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
    private final boolean standardOutput;
    private final boolean direct;
    private final ShutdownHook hook;
    private Path written;
    private Optional<Placement.Held> held = Optional.empty();
    private State state = State.OPEN;

    private AtomicFile(Path target, Overwrite overwrite) {
        this.target = target;
        this.overwrite = overwrite;
        this.standardOutput = StandardOutput.isMeant(target);
        this.direct = !standardOutput && Targets.isDevice(target);
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
            if (!probe.direct && !probe.standardOutput) {
                TemporaryFiles.sweep(Targets.folderOf(probe.written));
                probe.fill(stream -> stream.write(new byte[PROBE_BYTES]));
            }
        }
    }

    /**
     * As {@link #checkWritable}, before anything is read, for a target that the user may have named.
     *
     * @param named null for a name that Sunbeam will choose, which is checked when it is known
     */
    public static void checkNamed(Path named, Overwrite overwrite) {
        if (named != null) {
            checkWritable(named, overwrite);
        }
    }

    /**
     * Writes the whole target through a buffered stream; an {@link IOException} of the content is the target's.
     *
     * @return where it is, which another output's name decides with {@link Overwrite#NUMBER}
     */
    public static Path write(Path target, Overwrite overwrite, StreamContent content) {
        try (AtomicFile file = create(target, overwrite)) {
            file.fill(content);
            return file.commit();
        }
    }

    /** As {@link #write}, for libraries that open the file themselves. */
    public static Path writeFile(Path target, Overwrite overwrite, FileContent content) {
        try (AtomicFile file = create(target, overwrite)) {
            content.writeTo(file.path());
            return file.commit();
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
        Targets.check(target, overwrite);
        try {
            AtomicFile file = new AtomicFile(target, overwrite);
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
        boolean begun = false;
        try {
            written = standardOutput
                    ? Files.createTempFile("sunbeam-", ".part")
                    : TemporaryFiles.create(Targets.folderOf(target));
            begun = true;
        } finally {
            if (!begun) {
                close();
            }
        }
    }

    /**
     * Writes the content, which does not appear before {@link #commit}.
     *
     * @throws OutputException when it cannot be written, also when the content throws an {@link IOException}
     */
    public void fill(StreamContent content) {
        try (OutputStream stream = new BufferedOutputStream(open(), BUFFER_BYTES)) {
            content.writeTo(stream);
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        } catch (UncheckedIOException failure) {
            throw OutputException.of(target, failure.getCause());
        }
    }

    /** The file that was made, and no other: one that the end of the process has removed must not come again. */
    private OutputStream open() throws IOException {
        try {
            return Files.newOutputStream(path(), StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING);
        } catch (NoSuchFileException removed) {
            if (isClosed()) {
                CancelledException cancelled = new CancelledException();
                cancelled.addSuppressed(removed);
                throw cancelled;
            }
            throw removed;
        }
    }

    private synchronized boolean isClosed() {
        return state == State.CLOSED;
    }

    /** Where to write the content. Writers must have closed it before {@link #commit}. */
    public synchronized Path path() {
        return written;
    }

    /**
     * Makes the content appear under the target's name.
     *
     * @return the name, which is another than the target's where that was taken and {@link Overwrite#NUMBER} chosen
     * @throws OutputException when that fails, also because a file has appeared there meanwhile
     * @throws CancelledException when the process is being ended
     */
    public synchronized Path commit() {
        if (state == State.COMMITTED) {
            throw new IllegalStateException(target + " was committed before");
        }
        if (state == State.CLOSED) {
            throw new CancelledException();
        }
        try {
            Path place = appear();
            state = State.COMMITTED;
            return place;
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    private Path appear() throws IOException {
        if (direct) {
            return target;
        }
        if (standardOutput) {
            StandardOutput.copy(written);
            Files.delete(written);
            return target;
        }
        Durable.force(written);
        Path place = Placement.place(written, target, overwrite);
        Durable.forceFolder(Targets.folderOf(target));
        return place;
    }

    /**
     * The first half of {@link #commit}, for files that appear together: takes a name.
     *
     * @throws FileAlreadyExistsException when it is taken
     */
    synchronized void hold(Path name) throws IOException {
        if (state != State.OPEN) {
            throw new CancelledException();
        }
        Durable.force(written);
        held = Optional.of(Placement.hold(written, name));
    }

    /** Gives the name back that was taken. */
    synchronized void release() {
        if (state == State.OPEN && held.isPresent()) {
            try {
                held.get().release();
                held = Optional.empty();
            } catch (IOException failure) {
                throw OutputException.of(target, failure);
            }
        }
    }

    /** The second half of {@link #commit}: the name that was taken stays. */
    synchronized Path keep() throws IOException {
        if (state != State.OPEN) {
            throw new CancelledException();
        }
        Placement.Held name = held.orElseThrow();
        name.keep();
        state = State.COMMITTED;
        Durable.forceFolder(Targets.folderOf(name.name()));
        return name.name();
    }

    /** Removes what was written, unless it was committed. */
    @Override
    public void close() {
        try {
            discard();
        } finally {
            hook.close();
        }
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
            if (held.isPresent()) {
                held.get().release();
            }
            Files.deleteIfExists(written);
        } catch (IOException failure) {
            throw new OutputException("cannot remove the temporary file " + written + "; remove it by hand", failure);
        }
    }
}
