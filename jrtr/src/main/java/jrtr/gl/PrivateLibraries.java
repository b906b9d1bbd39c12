package jrtr.gl;

import com.jogamp.common.util.IOUtil;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.UserPrincipal;
import java.util.Comparator;
import java.util.stream.Stream;
import jrtr.GraphicsException;

/**
 * Where JOGL unpacks its native libraries, unless it is told not to because they lie unpacked on the library path. By
 * itself it takes a folder of a name that anybody can foresee, in the folder for temporary files, also one that another
 * user made and may write to: who replaces a library there runs code as this user. So JOGL is given a new folder of a
 * random name, which its owner alone may enter, and which is removed in the end.
 */
final class PrivateLibraries {
    private static final String TEMPORARY_FOLDER = "java.io.tmpdir";
    private static final String UNPACKING = "jogamp.gluegen.UseTempJarCache";
    private static final String PREFIX = "jrtr-libraries-";
    /** Locked by the process whose folder it is, for as long as it lives. */
    private static final String HELD = "held";

    private static boolean prepared;

    private PrivateLibraries() {}

    /**
     * To be called before anything else of JOGL's.
     *
     * @throws GraphicsException if there is no room for such a folder, or libraries must not be loaded from there
     */
    static synchronized void prepare() {
        if (!prepared && !"false".equals(System.getProperty(UNPACKING))) {
            Path shared = Path.of(System.getProperty(TEMPORARY_FOLDER));
            Path folder = create(shared);
            sweep(shared, folder);
            hand(folder);
        }
        prepared = true;
    }

    private static Path create(Path shared) {
        try {
            // Of mode 700, and new: one that is there already is never taken.
            Path folder = Files.createTempDirectory(shared, PREFIX);
            FileChannel held =
                    FileChannel.open(folder.resolve(HELD), StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            held.tryLock();
            Runtime.getRuntime().addShutdownHook(new Thread(() -> remove(folder, held), "jrtr-libraries"));
            return folder;
        } catch (IOException failure) {
            throw failure(shared, "a folder cannot be made there: " + reason(failure), failure);
        }
    }

    /** JOGL asks for the folder for temporary files once, and remembers what it found. */
    private static void hand(Path folder) {
        String before = System.setProperty(TEMPORARY_FOLDER, folder.toString());
        try {
            Path found = IOUtil.getTempDir(true).toPath();
            if (!found.toRealPath().startsWith(folder.toRealPath())) {
                throw failure(folder.getParent(), "it is full, or programs must not run there", null);
            }
        } catch (IOException | RuntimeException unusable) {
            throw unusable instanceof GraphicsException told
                    ? told
                    : failure(folder.getParent(), "it is full, or programs must not run there", unusable);
        } finally {
            System.setProperty(TEMPORARY_FOLDER, before);
        }
    }

    private static GraphicsException failure(Path shared, String why, Exception cause) {
        return new GraphicsException(
                "JOGL's native libraries cannot be unpacked to the folder for temporary files, " + shared + " (" + why
                        + "). Free some space there, or name another folder with -Djava.io.tmpdir=FOLDER",
                cause);
    }

    private static String reason(IOException failure) {
        if (failure instanceof FileSystemException ofFile && ofFile.getReason() != null) {
            return ofFile.getReason();
        }
        return failure.getClass().getSimpleName();
    }

    /** Removes what killed processes of this user left. Folders of others are not even looked into. */
    private static void sweep(Path shared, Path own) {
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(shared, PREFIX + "*")) {
            UserPrincipal user = Files.getOwner(own);
            for (Path folder : folders) {
                boolean mine = Files.getOwner(folder, LinkOption.NOFOLLOW_LINKS).equals(user);
                if (mine && !folder.equals(own) && isAbandoned(folder)) {
                    remove(folder);
                }
            }
        } catch (IOException | DirectoryIteratorException | UnsupportedOperationException unknown) {
            // Then they stay: they take room and harm nobody.
            return;
        }
    }

    /** Whether its process has ended. One that has not locked its folder yet, in its first moments, has none to lock. */
    private static boolean isAbandoned(Path folder) {
        try (FileChannel channel = FileChannel.open(folder.resolve(HELD), StandardOpenOption.WRITE);
                FileLock free = channel.tryLock()) {
            return free != null;
        } catch (IOException | OverlappingFileLockException unknown) {
            return false;
        }
    }

    /** The hook holds the channel, and so the lock, until then. */
    private static void remove(Path folder, FileChannel held) {
        remove(folder);
        try {
            held.close();
        } catch (IOException closedAnyway) {
            // The process ends.
            return;
        }
    }

    private static void remove(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        } catch (IOException | RuntimeException left) {
            // Still in use (on Windows): a later start tries again.
        }
    }
}
