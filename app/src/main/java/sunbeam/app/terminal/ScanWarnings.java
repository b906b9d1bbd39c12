package sunbeam.app.terminal;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import sunbeam.precompute.patch.Patch;

/** What is wrong with a scan in one line; each warning by itself is longer than most people read. */
public final class ScanWarnings {
    // Characters of a line that is read.
    private static final int LONGEST = 200;

    private ScanWarnings() {}

    /**
     * Prints a patch's notes, then all warnings in full for those who ask, else in one line.
     *
     * @param warnings the patch's and whatever else is said of it
     */
    public static void print(Patch patch, List<String> warnings, boolean explained, PrintWriter err) {
        patch.notes().forEach(note -> err.println(Messages.note(patch.name() + ": " + note)));
        if (explained) {
            warnings.forEach(warning -> err.println(Messages.warning(patch.name() + ": " + warning)));
        } else {
            line(patch.name(), warnings, "--explain").ifPresent(err::println);
        }
    }

    /**
     * The whole of a short one; of others their beginnings, up to the first colon.
     *
     * @param name of the scan
     * @param remedy the option that tells all of it
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
