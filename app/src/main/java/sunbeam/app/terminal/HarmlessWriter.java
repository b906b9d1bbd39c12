package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.util.regex.Pattern;

/**
 * Writer to a terminal that replaces characters which control it, since names of files and fields of tables may hold any. Control
 * characters other than line breaks and tabs, and those that change the direction of text, become {@code ?}.
 */
public class HarmlessWriter extends Writer {
    // C0 but for breaks and tabs, DEL, C1; then marks of direction, line and paragraph separators.
    private static final Pattern CONTROLLING = Pattern.compile(
            "[\\x00-\\x1f\\x7f-\\x9f&&[^\n\r\t]]|[\\u061c\\u200e\\u200f\\u2028-\\u202e\\u2066-\\u2069]");

    private final Writer out;

    private HarmlessWriter(Writer out) {
        this.out = out;
    }

    public static PrintWriter around(Writer out) {
        return new PrintWriter(new HarmlessWriter(out), true);
    }

    /** Wraps a writer that passes on only error messages, and drops plans, warnings, notes and reports. */
    public static PrintWriter ofErrors(Writer out) {
        return new PrintWriter(new OfErrors(out), true);
    }

    private static final class OfErrors extends HarmlessWriter {
        private final StringBuilder line = new StringBuilder();

        OfErrors(Writer out) {
            super(out);
        }

        @Override
        public void write(char[] text, int offset, int length) throws IOException {
            for (int i = offset; i < offset + length; i++) {
                line.append(text[i]);
                if (text[i] == '\n') {
                    char[] whole = line.toString().toCharArray();
                    line.setLength(0);
                    if (Messages.isError(String.valueOf(whole))) {
                        super.write(whole, 0, whole.length);
                    }
                }
            }
        }
    }

    @Override
    public void write(char[] text, int offset, int length) throws IOException {
        out.write(CONTROLLING.matcher(new String(text, offset, length)).replaceAll("?"));
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
