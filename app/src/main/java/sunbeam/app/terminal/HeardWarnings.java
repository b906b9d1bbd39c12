package sunbeam.app.terminal;

import java.io.FilterWriter;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;

/** Lines on their way to standard error, of which the warnings are kept for a file that tells them, too. */
public final class HeardWarnings extends FilterWriter {
    private final StringBuilder line = new StringBuilder();
    private final List<String> heard = new ArrayList<>();

    public HeardWarnings(Writer out) {
        super(out);
    }

    /** To write to; flushed with each line. */
    public PrintWriter printer() {
        return new PrintWriter(this, true);
    }

    /** The warnings so far, without the program's name, each once. */
    public synchronized List<String> all() {
        return heard.stream().distinct().toList();
    }

    @Override
    public synchronized void write(int character) throws IOException {
        out.write(character);
        listen((char) character);
    }

    @Override
    public synchronized void write(char[] text, int offset, int length) throws IOException {
        write(new String(text, offset, length), 0, length);
    }

    @Override
    public synchronized void write(String text, int offset, int length) throws IOException {
        out.write(text, offset, length);
        text.substring(offset, offset + length).chars().forEach(character -> listen((char) character));
    }

    private void listen(char character) {
        line.append(character);
        if (character == '\n') {
            Messages.warned(line.toString()).ifPresent(heard::add);
            line.setLength(0);
        }
    }
}
