package sunbeam.app.files.cache;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Consumer;

/**
 * One process at a time makes a table; the others wait for it and read what it has made. The lock is the operating
 * system's, which takes it back from a process that ends in any way. Where there is none, tables are made more than once,
 * which costs time only. Its empty file stays until the cache is cleared: who deleted it would divide those who wait from those who come.
 */
final class CacheLock implements AutoCloseable {
    private static final String ENDING = ".lock";

    private final FileChannel channel;

    private final boolean waited;

    private CacheLock(FileChannel channel, boolean waited) {
        this.channel = channel;
        this.waited = waited;
    }

    /**
     * Waits for the lock of a table's file.
     *
     * @param warning told where it has to wait
     */
    static CacheLock of(Path file, Consumer<String> warning) {
        FileChannel channel = null;
        boolean waited = false;
        try {
            channel = FileChannel.open(
                    file.resolveSibling(file.getFileName() + ENDING),
                    StandardOpenOption.CREATE,
                    StandardOpenOption.WRITE);
            FileLock lock = channel.tryLock();
            if (lock == null) {
                waited = true;
                warning.accept("another Sunbeam is making the same table: waiting for it");
                lock = channel.lock();
            }
            return new CacheLock(channel, waited);
        } catch (IOException | OverlappingFileLockException noLocks) {
            // A file system without locks, or another thread of this process.
            return new CacheLock(channel, waited);
        }
    }

    /** Whether a file's name is one of a lock. */
    static boolean isOne(Path file) {
        return file.getFileName().toString().endsWith(ENDING);
    }

    /**
     * Deletes a lock's file unless somebody holds it. Who opened it before and locks it after is alone with it: two processes
     * may then make the same table, which costs time only.
     */
    static void deleteUnheld(Path lock) {
        try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE);
                FileLock held = channel.tryLock()) {
            if (held != null) {
                Files.deleteIfExists(lock);
            }
        } catch (IOException | OverlappingFileLockException inUse) {
            return;
        }
    }

    /** Whether another process had it, which may have made the table. */
    boolean waited() {
        return waited;
    }

    @Override
    public void close() {
        try {
            if (channel != null) {
                channel.close();
            }
        } catch (IOException failure) {
            return;
        }
    }
}
