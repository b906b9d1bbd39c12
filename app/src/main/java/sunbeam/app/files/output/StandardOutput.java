package sunbeam.app.files.output;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import sunbeam.precompute.text.Quoted;

/** The name {@code -}, which is standard output, as a command line knows it. A file of that name is {@code ./-}. */
public final class StandardOutput {
    private static final Path NAME = Path.of("-");

    private StandardOutput() {}

    /** Whether a target that the user named is standard output. */
    public static boolean isMeant(Path target) {
        return NAME.equals(target);
    }

    /** The name of a target in reports, on one line. */
    public static String name(Path target) {
        return isMeant(target) ? "written to standard output" : Quoted.oneLine(target.toString());
    }

    /** Copies a complete file there. The stream stays open: it is the process's. */
    static void copy(Path file) throws IOException {
        Files.copy(file, new FileOutputStream(FileDescriptor.out));
    }
}
