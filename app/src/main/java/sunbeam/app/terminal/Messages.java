package sunbeam.app.terminal;

import java.util.stream.Collectors;

/** The form of what is said on standard error: one line, led by the program's name. */
public final class Messages {
    private Messages() {}

    /** {@code sunbeam: message}, with line breaks in the message turned into blanks. */
    public static String error(String message) {
        return "sunbeam: " + oneLine(message);
    }

    /** {@code sunbeam: warning: message}, with line breaks in the message turned into blanks. */
    public static String warning(String message) {
        return "sunbeam: warning: " + oneLine(message);
    }

    /** {@code sunbeam: note: message}, with line breaks in the message turned into blanks. */
    public static String note(String message) {
        return "sunbeam: note: " + oneLine(message);
    }

    private static String oneLine(String message) {
        return message.lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .collect(Collectors.joining(" "));
    }
}
