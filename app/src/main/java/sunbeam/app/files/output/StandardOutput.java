package sunbeam.app.files.output;

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
}
