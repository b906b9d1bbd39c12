package sunbeam.app.files.output;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import sunbeam.precompute.text.Quoted;

/** Standard output as a target, {@code -}; a file of this name is {@code ./-}. */
public final class StandardOutput {
    private static final Path NAME = Path.of("-");

    private StandardOutput() {}

    public static boolean isMeant(Path target) {
        return NAME.equals(target);
    }

    public static String name(Path target) {
        return isMeant(target) ? "written to standard output" : Quoted.oneLine(target.toString());
    }

    static void copy(Path file) throws IOException {
        Files.copy(file, new FileOutputStream(FileDescriptor.out));
    }
}
