package sunbeam.app.input;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The lines of comma-separated text that are not blank, split into fields (RFC 4180, but a field stays on its line). */
final class CsvLines implements AutoCloseable {
    private static final int LONGEST_LINE = 1 << 16;
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private final Path file;
    private final BufferedReader reader;
    private final StringBuilder line = new StringBuilder();
    private int number;

    /** @throws InputException when the file is a folder */
    CsvLines(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new InputException("cannot read " + file + ": it is a folder; name a file in it");
        }
        this.file = file;
        // Malformed bytes become replacement characters: harmless in columns that nobody wants, no number elsewhere.
        reader = new BufferedReader(new InputStreamReader(Files.newInputStream(file), StandardCharsets.UTF_8));
    }

    /** Goes to the next line that is not blank; false at the end of the file. */
    boolean next() throws IOException {
        while (readLine()) {
            if (!line.toString().isBlank()) {
                return true;
            }
        }
        return false;
    }

    /** Number of the current line in the file, from 1. */
    int number() {
        return number;
    }

    /** The current line's fields, quotes removed. */
    List<String> fields() {
        List<String> fields = new ArrayList<>();
        StringBuilder field = new StringBuilder();
        boolean quoted = false;
        for (int index = 0; index < line.length(); index++) {
            char character = line.charAt(index);
            boolean doubledQuote =
                    quoted && character == '"' && index + 1 < line.length() && line.charAt(index + 1) == '"';
            if (doubledQuote) {
                field.append('"');
                index++;
            } else if (character == '"') {
                quoted = !quoted;
            } else if (character == ',' && !quoted) {
                fields.add(field.toString());
                field.setLength(0);
            } else {
                field.append(character);
            }
        }
        if (quoted) {
            throw new InputException("cannot use " + file + ", line " + number + ": a quote is not closed");
        }
        fields.add(field.toString());
        return fields;
    }

    @Override
    public void close() throws IOException {
        reader.close();
    }

    /** Not BufferedReader.readLine: a file without line ends would fill the memory. */
    private boolean readLine() throws IOException {
        line.setLength(0);
        int character = reader.read();
        if (character < 0) {
            return false;
        }
        number++;
        for (; character >= 0 && character != '\n'; character = reader.read()) {
            if (line.length() == LONGEST_LINE) {
                throw new InputException("cannot use " + file + ", line " + number + ": longer than " + LONGEST_LINE
                        + " characters; is this a table?");
            }
            line.append((char) character);
        }
        if (line.length() > 0 && line.charAt(line.length() - 1) == '\r') {
            line.setLength(line.length() - 1);
        }
        if (number == 1 && line.length() > 0 && line.charAt(0) == BYTE_ORDER_MARK) {
            line.deleteCharAt(0);
        }
        return true;
    }
}
