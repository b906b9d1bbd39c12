package sunbeam.app.files.output;

import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A table of numbers as comma-separated text: a header row, then one row per call, 13 significant digits in scientific
 * notation (a relative rounding of at most 5e-13), {@code NaN} and {@code Infinity} spelled so, lines ended by a line
 * feed.
 */
public final class CsvWriter implements AutoCloseable {
    private final Writer writer;
    private final int columns;

    /**
     * A table of anything as text: a header and a line for each row; names and texts are quoted where they must be.
     *
     * @param rows of the same columns, at least one
     */
    public static String text(List<? extends Map<String, ?>> rows) {
        StringWriter text = new StringWriter();
        var csv = de.siegmar.fastcsv.writer.CsvWriter.builder()
                .lineDelimiter(LineDelimiter.LF)
                .bufferSize(0)
                .build(text);
        csv.writeRecord(rows.get(0).keySet());
        rows.forEach(row ->
                csv.writeRecord(row.values().stream().map(String::valueOf).toList()));
        return text.toString();
    }

    /**
     * Writes the header.
     *
     * @param stream is flushed, not closed, when this is closed
     * @param names columns from left to right, at least one; letters, digits, {@code _ . -} and blanks only
     */
    public CsvWriter(OutputStream stream, List<String> names) throws IOException {
        for (String name : names) {
            if (!name.matches("[A-Za-z0-9_. -]+")) {
                throw new IllegalArgumentException("not a column's name: '" + name + "'");
            }
        }
        if (names.isEmpty()) {
            throw new IllegalArgumentException("a table needs a column");
        }
        writer = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.UTF_8));
        columns = names.size();
        writer.write(String.join(",", names) + "\n");
    }

    /** Writes a row: one value for each column. */
    public void row(double... values) throws IOException {
        if (values.length != columns) {
            throw new IllegalArgumentException(values.length + " values for " + columns + " columns");
        }
        for (int column = 0; column < columns; column++) {
            if (column > 0) {
                writer.write(',');
            }
            writer.write(format(values[column]));
        }
        writer.write('\n');
    }

    @Override
    public void close() throws IOException {
        writer.flush();
    }

    private static String format(double value) {
        return Double.isFinite(value) ? String.format(Locale.ROOT, "%.12e", value) : Double.toString(value);
    }
}
