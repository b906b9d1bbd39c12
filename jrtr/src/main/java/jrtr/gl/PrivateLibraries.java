package jrtr.gl;

import com.jogamp.common.util.IOUtil;
import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
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
    /** Libraries are loaded within seconds of a start: then nobody needs the folder of a process that was killed. */
    private static final Duration LONG_AGO = Duration.ofDays(1);

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
            sweep(shared);
            Path folder = create(shared);
            Runtime.getRuntime().addShutdownHook(new Thread(() -> remove(folder), "jrtr-libraries"));
            hand(folder);
        }
        prepared = true;
    }

    private static Path create(Path shared) {
        try {
            // Of mode 700, and new: one that is there already is never taken.
            return Files.createTempDirectory(shared, PREFIX);
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

    /** What killed processes of this user left; folders of others cannot be removed, and stay. */
    private static void sweep(Path shared) {
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(shared, PREFIX + "*")) {
            Instant latest = Instant.now().minus(LONG_AGO);
            for (Path folder : folders) {
                if (Files.getLastModifiedTime(folder).toInstant().isBefore(latest)) {
                    remove(folder);
                }
            }
        } catch (IOException | DirectoryIteratorException unlisted) {
            // Whether the folder can be used is found out when a new one is made in it.
        }
    }

    private static void remove(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        } catch (IOException | RuntimeException left) {
            // Of another user, or still in use (on Windows): a later start tries again.
        }
    }
}
