package sunbeam.app.files.input;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** First line {@code sep=;} of a table, by which Excel learns the separator of columns. */
final class SeparatorLine {
    /** Characters, more than any such line has. */
    static final int LONGEST = 16;

    private static final Pattern LINE = Pattern.compile("(?i)\ufeff?\"?sep=([^\r\n\"])\"?(?:\r?\n|\r|$)");

    private SeparatorLine() {}

    /** Returns the line with its end, if a text begins so. */
    static Optional<String> of(String text) {
        Matcher line = LINE.matcher(text);
        return line.lookingAt() ? Optional.of(line.group()) : Optional.empty();
    }

    static char separator(String line) {
        Matcher found = LINE.matcher(line);
        return found.lookingAt() ? found.group(1).charAt(0) : ',';
    }
}
