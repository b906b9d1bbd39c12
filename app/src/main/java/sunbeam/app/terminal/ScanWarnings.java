package sunbeam.app.terminal;

import java.io.PrintWriter;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import sunbeam.precompute.patch.Patch;

/** What the user should know of a scan; several warnings in one line, as each by itself is longer than most people read. */
public final class ScanWarnings {
    // Characters of a line that is read.
    private static final int LONGEST = 200;

    private ScanWarnings() {}

    /**
     * Prints a patch's notes and warnings: the whole of a short one, of others their beginnings, up to the first colon.
     *
     * @param more warnings
     * @param whole whether each is printed in full, as {@code --explain} asks for
     */
    public static void print(Patch patch, List<String> more, boolean whole, PrintWriter err) {
        String name = patch.name() + ": ";
        patch.notes().forEach(note -> err.println(Messages.note(name + note)));
        List<String> warnings =
                Stream.concat(patch.warnings().stream(), more.stream()).toList();
        if (whole || (warnings.size() == 1 && warnings.get(0).length() <= LONGEST)) {
            warnings.forEach(warning -> err.println(Messages.warning(name + warning)));
        } else if (!warnings.isEmpty()) {
            String heads = warnings.stream().map(ScanWarnings::head).collect(Collectors.joining("; "));
            err.println(Messages.warning(name + heads + " (--explain tells more)"));
        }
        err.flush();
    }

    private static String head(String warning) {
        int colon = warning.indexOf(": ");
        return colon < 0 ? warning : warning.substring(0, colon);
    }
}
