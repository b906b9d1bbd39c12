package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.util.regex.Pattern;

/**
 * Writer to a terminal that replaces characters which control it, since names of files and fields of tables may hold any. Control
 * characters other than line breaks and tabs, and those that change the direction of text, become {@code ?}.
 */
public final class HarmlessWriter extends Writer {
    // C0 but for breaks and tabs, DEL, C1; then marks of direction, line and paragraph separators.
    private static final Pattern CONTROLLING = Pattern.compile(
            "[\\x00-\\x1f\\x7f-\\x9f&&[^\n\r\t]]|[\\u061c\\u200e\\u200f\\u2028-\\u202e\\u2066-\\u2069]");

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
                if (Messages.isError(line.toString())) {
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
