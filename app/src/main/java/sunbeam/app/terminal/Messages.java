package sunbeam.app.terminal;

import java.util.stream.Collectors;

/** The form of what is said on standard error: one line, led by the program's name. */
public final class Messages {
    /** A name of a file may take 4096 bytes; whatever is longer is no message. */
    private static final int LONGEST = 6000;

    private static final String ERROR = "sunbeam: ";
    private static final String WARNING = ERROR + "warning: ";
    private static final String NOTE = ERROR + "note: ";

    private Messages() {}

    static boolean isError(String line) {
        return line.startsWith(ERROR) && !line.startsWith(WARNING) && !line.startsWith(NOTE);
    }

    /** {@code sunbeam: message}, with line breaks in the message turned into blanks. */
    public static String error(String message) {
        return ERROR + oneLine(message);
    }

    /** {@code sunbeam: warning: message}, with line breaks in the message turned into blanks. */
    public static String warning(String message) {
        return WARNING + oneLine(message);
    }

    /** {@code sunbeam: note: message}, with line breaks in the message turned into blanks. */
    public static String note(String message) {
        return NOTE + oneLine(message);
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
