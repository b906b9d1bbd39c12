package sunbeam.app.commands.sample;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.app.terminal.UsageException;

/**
 * One of several parts of all rows, which follow each other.
 *
 * @param number from 1
 * @param parts at least 1
 */
record RowPart(int number, int parts) {
    private static final Pattern TEXT = Pattern.compile("(\\d{1,6})/(\\d{1,6})");

    /** @throws UsageException for a text that names none */
    static RowPart parse(String text) {
        Matcher matcher = TEXT.matcher(text);
        if (matcher.matches()) {
            RowPart part = new RowPart(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)));
            if (part.number >= 1 && part.number <= part.parts) {
                return part;
            }
        }
        throw new UsageException(
                "--task " + text + " names no part; give I/N, 1/8 to 8/8 for the eight parts of eight");
    }

    /** Number of its first row. */
    long first(long count) {
        return count * (number - 1) / parts;
    }

    /** Number behind its last row. */
    long end(long count) {
        return count * number / parts;
    }
}
