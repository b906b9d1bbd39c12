package sunbeam.app.files.output;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.function.IntFunction;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.ShutdownHook.CancelledException;

/**
 * Output file that appears whole or not at all. It is written beside its target under a temporary name, forced to the disk and renamed. A
 * failure, {@link #close} without {@link #commit}, or the end of the process (Ctrl-C) removes it. A symbolic link in the target's place is
 * replaced; the file to which it leads stays. A target that is a device or a pipe ({@code /dev/null}) is written directly; {@code -} is
 * standard output, to which the complete content is copied.
 */
public final class AtomicFile implements AutoCloseable {
    private static final int BUFFER_BYTES = 1 << 16;
    /** Bytes written to check for room: one block of usual file systems, which a full disk does not take. */
    private static final int PROBE_BYTES = 4096;

    private final Path target;
    private final Overwrite overwrite;
    private final boolean isStandardOutput;
    private final boolean isDevice;
    private final ShutdownHook hook;
    // A temporary file, or the target itself.
    private Path contentPath;
    // Name reserved before the commit, or null.
    private Path claimedName;
    private boolean isOpen = true;

    private AtomicFile(Path target, Overwrite overwrite) {
        this.target = target;
        this.overwrite = overwrite;
        this.isStandardOutput = OutputFolder.isStandardOutput(target);
        this.isDevice = !isStandardOutput && OutputFolder.isDevice(target);
        this.contentPath = target;
        hook = new ShutdownHook(this::discard);
    }

    @FunctionalInterface
    public interface FileContent {
        void writeTo(Path file) throws IOException;
    }

    /**
     * Throws {@link OutputException} unless the target can be written: the folder takes a file, the disk has room for a block, no file is
     * in the way. A target of null, a name that Sunbeam will choose, is not checked.
     */
    public static void checkWritable(Path target, Overwrite overwrite) {
        if (target == null) {
            return;
        }
        try (AtomicFile probe = create(target, overwrite)) {
            if (!probe.isDevice && !probe.isStandardOutput) {
                OutputFolder.sweep(OutputFolder.of(target));
                probe.fill(stream -> stream.write(new byte[PROBE_BYTES]));
            }
        }
    }

    /** Refuses a file that exceeds the free space: "TAKES 3 MB and 2 MB are free; REMEDY, or choose another folder". */
    public static void requireRoom(Path target, long bytes, String takes, String remedy) {
        long free = OutputFolder.of(target).toFile().getUsableSpace();
        if (bytes > free && !OutputFolder.isStandardOutput(target)) {
            throw new OutputException("cannot write " + target + ": " + takes + " " + ByteSize.format(bytes) + " and "
                    + ByteSize.format(free) + " are free; " + remedy + ", or choose another folder");
        }
    }

    /** Writes the target through a buffered stream; returns its path as {@link #commit} does, and throws as {@link #fill} does. */
    public static Path write(Path target, Overwrite overwrite, StreamContent content) {
        try (AtomicFile file = create(target, overwrite)) {
            file.fill(content);
            return file.commit();
        }
    }

    /** Writes the whole target like {@link #write}, for libraries that open the file themselves. */
    public static Path writeFile(Path target, Overwrite overwrite, FileContent content) {
        try (AtomicFile file = create(target, overwrite)) {
            file.fillFile(content);
            return file.commit();
        }
    }

    /** Throws {@link OutputException} if the target is a folder, may not be replaced, or its folder is missing or takes no file. */
    public static AtomicFile create(Path target, Overwrite overwrite) {
        OutputFolder.checkTarget(target, overwrite);
        AtomicFile file = new AtomicFile(target, overwrite);
        try {
            file.begin();
            return file;
        } catch (IOException failure) {
            file.close();
            throw OutputException.of(target, failure);
        }
    }

    /** Creates the temporary file. It is not done in the constructor, so that the shutdown hook sees either no file or its name. */
    private synchronized void begin() throws IOException {
        requireOpen();
        if (isStandardOutput) {
            contentPath = Files.createTempFile("sunbeam-", ".part");
        } else if (!isDevice) {
            contentPath = OutputFolder.createTemporary(OutputFolder.of(target));
            if (overwrite == Overwrite.REPLACE) {
                OutputFolder.copyMode(target, contentPath);
            }
        }
    }

    /** The end of the process closes the file, too. */
    private synchronized void requireOpen() {
        if (!isOpen) {
            throw new CancelledException();
        }
    }

    /** Writes the content, which does not appear before {@link #commit}. Throws {@link OutputException} if it cannot be written. */
    public void fill(StreamContent content) {
        fillFile(path -> {
            try (OutputStream stream = new BufferedOutputStream(open(), BUFFER_BYTES)) {
                content.writeTo(stream);
            }
        });
    }

    private void fillFile(FileContent content) {
        try {
            content.writeTo(path());
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        } catch (UncheckedIOException failure) {
            throw OutputException.of(target, failure.getCause());
        }
    }

    /** Opens the temporary file without creating it: if the end of the process has removed it, it must stay removed. */
    private OutputStream open() throws IOException {
        try {
            return isDevice
                    ? Files.newOutputStream(target, StandardOpenOption.WRITE)
                    : Files.newOutputStream(path(), StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
        } catch (NoSuchFileException removed) {
            requireOpen();
            throw removed;
        }
    }

    /** Returns the path to write the content to. The file there must be closed before {@link #commit}. */
    public synchronized Path path() {
        return contentPath;
    }

    /**
     * Makes the content appear under the target's name; returns its path, which may have a number with {@link Overwrite#NUMBER}. Throws
     * {@link OutputException} if, for example, a file has appeared under the name meanwhile.
     */
    public Path commit() {
        try {
            return commitAll(List.of(this), number -> List.of(OutputFolder.numbered(target, number)))
                    .get(0);
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    /** Makes several files appear, or none, under the names with the lowest number from 1 for which all are free or may be replaced. */
    static List<Path> commitAll(List<AtomicFile> files, IntFunction<List<Path>> names) throws IOException {
        for (int number = 1; ; number++) {
            List<Path> places = names.apply(number);
            try {
                for (int i = 0; i < files.size(); i++) {
                    files.get(i).claim(places.get(i));
                }
                for (int i = 0; i < files.size(); i++) {
                    files.get(i).appear(places.get(i));
                }
                return places;
            } catch (FileAlreadyExistsException taken) {
                for (AtomicFile file : files) {
                    file.release();
                }
                if (files.get(0).overwrite != Overwrite.NUMBER) {
                    throw OutputException.of(Path.of(taken.getFile()), taken);
                }
                if (number == OutputFolder.MOST_NAMES) {
                    throw new OutputException.Exists("cannot write " + taken.getFile()
                            + ": so many exist already; name one with --output, or add --force");
                }
            }
        }
    }

    /** Reserves a free name by link(2), which fails if the name exists. With a check before a rename, two writers could both succeed. */
    private synchronized void claim(Path name) throws IOException {
        requireOpen();
        if (isDevice || isStandardOutput) {
            return;
        }
        force(contentPath, StandardOpenOption.WRITE);
        if (overwrite == Overwrite.REPLACE) {
            return;
        }
        try {
            Files.createLink(name, contentPath);
        } catch (FileAlreadyExistsException taken) {
            throw taken;
        } catch (UnsupportedOperationException | FileSystemException noLinks) {
            // File systems without hard links (FAT, some network ones): an empty file reserves the name.
            Files.createFile(name);
        }
        claimedName = name;
    }

    private synchronized void appear(Path name) throws IOException {
        requireOpen();
        if (isStandardOutput) {
            Files.copy(contentPath, new FileOutputStream(FileDescriptor.out));
        } else if (!isDevice) {
            // rename(2) changes nothing if the name is a link to the content.
            Files.move(contentPath, name, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
        isOpen = false;
        if (!isDevice) {
            // If this fails, a later sweep removes the file like those of killed processes.
            contentPath.toFile().delete();
        }
        try {
            // Against power failures. Some systems cannot force a folder; the file is whole nevertheless.
            force(OutputFolder.of(name), StandardOpenOption.READ);
        } catch (IOException unable) {
            return;
        }
    }

    private static void force(Path file, StandardOpenOption access) throws IOException {
        try (FileChannel channel = FileChannel.open(file, access)) {
            channel.force(true);
        }
    }

    private synchronized void release() throws IOException {
        if (isOpen && claimedName != null) {
            Files.deleteIfExists(claimedName);
            claimedName = null;
        }
    }

    /** Removes the temporary file and the reserved name unless committed. */
    @Override
    public void close() {
        try {
            discard();
        } finally {
            hook.close();
        }
    }

    private synchronized void discard() {
        try {
            release();
            if (isOpen && !contentPath.equals(target)) {
                Files.deleteIfExists(contentPath);
            }
            isOpen = false;
        } catch (IOException failure) {
            throw new OutputException(
                    "cannot remove the temporary file " + contentPath + "; remove it by hand", failure);
        }
    }
}
