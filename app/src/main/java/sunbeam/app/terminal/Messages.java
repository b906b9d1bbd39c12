package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import sunbeam.precompute.patch.Patch;

/** Formats messages on standard error: one line that begins with the program's name. */
public final class Messages {
    // In characters: the name of a file alone may have 4096 bytes.
    private static final int LONGEST = 6000;

    private static final int LONGEST_WARNING = 200;
    private static final String ERROR = "sunbeam: ";
    private static final String WARNING = ERROR + "warning: ";
    private static final String NOTE = ERROR + "note: ";

    private Messages() {}

    static boolean isError(String line) {
        return line.startsWith(ERROR) && !line.startsWith(WARNING) && !line.startsWith(NOTE);
    }

    /** Returns {@code sunbeam: message}, with blanks for line breaks, as {@link #warning} and {@link #note} do. */
    public static String error(String message) {
        return ERROR + oneLine(message);
    }

    public static String warning(String message) {
        return WARNING + oneLine(message);
    }

    public static String note(String message) {
        return NOTE + oneLine(message);
    }

    public static String last(String err) {
        return err.lines()
                .reduce((first, second) -> second)
                .orElse("no message")
                .replaceFirst("^" + ERROR, "");
    }

    private static String oneLine(String message) {
        String line = message.lines()
                .map(String::strip)
                .filter(part -> !part.isEmpty())
                .collect(Collectors.joining(" "));
        // The beginning names the place, the end the remedy.
        int half = LONGEST / 2;
        return line.length() <= LONGEST
                ? line
                : line.substring(0, half) + " ... " + line.substring(line.length() - half);
    }

    /** Prints a patch's notes, then the warnings about its scan, in full or abbreviated to one line. */
    public static void printScan(Patch patch, List<String> warnings, boolean explained, PrintWriter err) {
        patch.notes().forEach(note -> err.println(note(patch.name() + ": " + note)));
        if (explained) {
            warnings.forEach(warning -> err.println(warning(patch.name() + ": " + warning)));
        } else {
            scanWarning(patch.name(), warnings, "--explain").ifPresent(err::println);
        }
    }

    /** Returns one line: a single short warning, else all up to their first colons and the remedy, which prints them in full. */
    public static Optional<String> scanWarning(String name, List<String> warnings, String remedy) {
        if (warnings.isEmpty()) {
            return Optional.empty();
        }
        boolean whole = warnings.size() == 1 && warnings.get(0).length() <= LONGEST_WARNING;
        String heads = whole
                ? warnings.get(0)
                : warnings.stream().map(warning -> warning.split(": ", 2)[0]).collect(Collectors.joining("; ")) + " ("
                        + remedy + " tells more)";
        return Optional.of(warning(name + ": " + heads));
    }

    /**
     * Writer to a terminal that replaces characters which control it, since names of files and fields of tables may hold any. Control
     * characters other than line breaks and tabs, and those that change the direction of text, become {@code ?}.
     */
    public static final class HarmlessWriter extends Writer {
        /** C0 but for line breaks and tabs, DEL, C1; marks of direction, line and paragraph separators. */
        public static final Pattern CONTROLLING = Pattern.compile(
                "[\\x00-\\x1f\\x7f-\\x9f&&[^\n\r\t]]|\r(?!\n)|[\\u061c\\u200e\\u200f\\u2028-\\u202e\\u2066-\\u2069]");

        private final Writer out;
        private final boolean onlyErrors;
        private final StringBuilder line = new StringBuilder();

        private HarmlessWriter(Writer out, boolean onlyErrors) {
            this.out = out;
            this.onlyErrors = onlyErrors;
        }

        public static PrintWriter around(Writer out) {
            return new PrintWriter(new HarmlessWriter(out, false), true);
        }

        /** Wraps a writer that passes on only error messages, and drops plans, warnings, notes and reports. */
        public static PrintWriter ofErrors(Writer out) {
            return new PrintWriter(new HarmlessWriter(out, true), true);
        }

        @Override
        public void write(char[] text, int offset, int length) throws IOException {
            if (!onlyErrors) {
                pass(new String(text, offset, length));
                return;
            }
            for (int i = offset; i < offset + length; i++) {
                line.append(text[i]);
                if (text[i] == '\n') {
                    if (isError(line.toString())) {
                        pass(line.toString());
                    }
                    line.setLength(0);
                }
            }
        }

        private void pass(String text) throws IOException {
            out.write(CONTROLLING.matcher(text).replaceAll("?"));
        }

        @Override
        public void flush() throws IOException {
            out.flush();
        }

        @Override
        public void close() throws IOException {
            out.close();
        }
    }
}
