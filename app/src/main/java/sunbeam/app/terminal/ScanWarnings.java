package sunbeam.app.terminal;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import sunbeam.precompute.patch.Patch;

/** Prints the warnings about a scan, in full or abbreviated to one line. */
public final class ScanWarnings {
    private static final int LONGEST = 200;

    private ScanWarnings() {}

    /** Prints a patch's notes, then its warnings. */
    public static void print(Patch patch, List<String> warnings, boolean explained, PrintWriter err) {
        patch.notes().forEach(note -> err.println(Messages.note(patch.name() + ": " + note)));
        if (explained) {
            warnings.forEach(warning -> err.println(Messages.warning(patch.name() + ": " + warning)));
        } else {
            line(patch.name(), warnings, "--explain").ifPresent(err::println);
        }
    }

    /**
     * Returns one line: a single short warning in full, else the beginnings of all warnings, up to the first colon.
     *
     * @param remedy command or option that prints them in full
     */
    public static Optional<String> line(String name, List<String> warnings, String remedy) {
        if (warnings.isEmpty()) {
            return Optional.empty();
        }
        boolean whole = warnings.size() == 1 && warnings.get(0).length() <= LONGEST;
        String heads = whole
                ? warnings.get(0)
                : warnings.stream().map(ScanWarnings::head).collect(Collectors.joining("; ")) + " (" + remedy
                        + " tells more)";
        return Optional.of(Messages.warning(name + ": " + heads));
    }

    private static String head(String warning) {
        int colon = warning.indexOf(": ");
        return colon < 0 ? warning : warning.substring(0, colon);
    }
}
