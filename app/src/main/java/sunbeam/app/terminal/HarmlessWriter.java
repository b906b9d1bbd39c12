package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;

/**
 * Writer to a terminal that replaces characters which control it, since names of files and fields of tables may hold any. Control
 * characters other than line breaks and tabs, and those that change the direction of text, become {@code ?}.
 */
public class HarmlessWriter extends Writer {
    private static final char REPLACEMENT = '?';

    private final Writer out;

    private HarmlessWriter(Writer out) {
        this.out = out;
    }

    /** Wraps a writer, which is flushed after each line. */
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
        char[] shown = new char[length];
        for (int i = 0; i < length; i++) {
            shown[i] = harmless(text[offset + i]);
        }
        out.write(shown, 0, length);
    }

    @Override
    public void flush() throws IOException {
        out.flush();
    }

    @Override
    public void close() throws IOException {
        out.close();
    }

    private static char harmless(char character) {
        if (character == '\n' || character == '\r' || character == '\t') {
            return character;
        }
        return isControlling(character) ? REPLACEMENT : character;
    }

    /** True for controls (C0, DEL, C1), line and paragraph separators, and characters that change the direction of text. */
    private static boolean isControlling(char character) {
        boolean direction = character == '\u061c'
                || character == '\u200e'
                || character == '\u200f'
                || (character >= '\u202a' && character <= '\u202e')
                || (character >= '\u2066' && character <= '\u2069');
        return direction || Character.isISOControl(character) || character == '\u2028' || character == '\u2029';
    }
}
