package jrtr.gl;

import com.jogamp.common.util.IOUtil;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
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

    private static boolean prepared;

    private PrivateLibraries() {}

    /** To be called before anything else of JOGL's. */
    static synchronized void prepare() {
        if (!prepared && !"false".equals(System.getProperty(UNPACKING))) {
            Path shared = Path.of(System.getProperty(TEMPORARY_FOLDER));
            try {
                // Of mode 700, and new: one that is there already is never taken.
                Path folder = Files.createTempDirectory(shared, "jrtr-libraries-");
                Runtime.getRuntime().addShutdownHook(new Thread(() -> remove(folder), "jrtr-libraries"));
                hand(folder);
            } catch (IOException failure) {
                boolean told = failure instanceof FileSystemException ofFile && ofFile.getReason() != null;
                String reason = told
                        ? ((FileSystemException) failure).getReason()
                        : failure.getClass().getSimpleName();
                throw failure(shared, "a folder cannot be made there: " + reason, failure);
            }
        }
        prepared = true;
    }

    /** JOGL asks for the folder for temporary files once, and remembers what it found. */
    private static void hand(Path folder) throws IOException {
        String before = System.setProperty(TEMPORARY_FOLDER, folder.toString());
        boolean taken = false;
        try {
            taken = IOUtil.getTempDir(true).toPath().toRealPath().startsWith(folder.toRealPath());
        } catch (IOException | RuntimeException unusable) {
            throw failure(folder.getParent(), "it is full, or programs must not run there", unusable);
        } finally {
            System.setProperty(TEMPORARY_FOLDER, before);
        }
        if (!taken) {
            throw failure(folder.getParent(), "it is full, or programs must not run there", null);
        }
    }

    private static GraphicsException failure(Path shared, String why, Exception cause) {
        return new GraphicsException(
                "JOGL's native libraries cannot be unpacked to the folder for temporary files, " + shared + " (" + why
                        + "). Free some space there, or name another folder with -Djava.io.tmpdir=FOLDER",
                cause);
    }

    private static void remove(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        } catch (IOException | RuntimeException left) {
            // Still in use (on Windows).
        }
    }
}
