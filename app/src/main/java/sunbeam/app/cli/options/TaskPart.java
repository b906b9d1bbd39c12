package sunbeam.app.cli.options;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.app.terminal.UsageException;

/** Value of the option {@code --task I/N}: the I-th, from 1, of N consecutive parts of a list. */
public record TaskPart(int number, int parts) {
    private static final Pattern TEXT = Pattern.compile("(\\d{1,6})/(\\d{1,6})");

    public static TaskPart parse(String text) {
        Matcher matcher = TEXT.matcher(text);
        if (matcher.matches()) {
            TaskPart part = new TaskPart(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)));
            if (part.number >= 1 && part.number <= part.parts) {
                return part;
            }
        }
        throw new UsageException(
                "--task " + text + " names no part; give I/N, 1/8 to 8/8 for the eight parts of eight");
    }

    /** Returns the index of the part's first item among {@code count}. */
    public long first(long count) {
        return count * (number - 1) / parts;
    }

    /** Returns the index after the part's last item. */
    public long end(long count) {
        return count * number / parts;
    }
}
