package sunbeam.app.terminal;

import java.util.stream.Collectors;

/** The form of what is said on standard error: one line, led by the program's name. */
public final class Messages {
    /** A name of a file may take 4096 bytes; whatever is longer is no message. */
    private static final int LONGEST = 6000;

    private static final String WARNING = "sunbeam: warning: ";

    private Messages() {}

    /** Whether a line is one of {@link #warning}. */
    static boolean isWarning(String line) {
        return line.startsWith(WARNING);
    }

    /** {@code sunbeam: message}, with line breaks in the message turned into blanks. */
    public static String error(String message) {
        return "sunbeam: " + oneLine(message);
    }

    /** {@code sunbeam: warning: message}, with line breaks in the message turned into blanks. */
    public static String warning(String message) {
        return WARNING + oneLine(message);
    }

    /** {@code sunbeam: note: message}, with line breaks in the message turned into blanks. */
    public static String note(String message) {
        return "sunbeam: note: " + oneLine(message);
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
}
