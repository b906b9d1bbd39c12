package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;

/** Writer to standard error that passes on only error messages, and drops plans, warnings, notes and reports. */
public final class QuietWriter extends Writer {
    private final Writer out;
    private final StringBuilder line = new StringBuilder();

    private QuietWriter(Writer out) {
        this.out = out;
    }

    /** Wraps a writer, which is flushed after each line. */
    public static PrintWriter around(Writer out) {
        return new PrintWriter(new QuietWriter(out), true);
    }

    @Override
    public void write(char[] text, int offset, int length) throws IOException {
        for (int i = 0; i < length; i++) {
            line.append(text[offset + i]);
            if (text[offset + i] == '\n') {
                String whole = line.toString();
                line.setLength(0);
                if (Messages.isError(whole)) {
                    out.write(whole);
                }
            }
        }
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
