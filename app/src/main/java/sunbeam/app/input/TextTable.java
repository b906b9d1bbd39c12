package sunbeam.app.input;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Named columns of text from comma-separated text with a header row: {@link CsvTable} for what are no numbers. At most a
 * million rows.
 */
public final class TextTable {
    private static final int MOST_ROWS = 1_000_000;

    private TextTable() {}

    /**
     * Reads a table.
     *
     * @param required columns that must be there; others are skipped
     * @return for each row, the fields by column
     * @throws InputException when the file cannot be read, has no row, lacks a column, or has a row of another length
     */
    public static List<Map<String, String>> read(Path file, List<String> required) {
        try (CsvLines lines = new CsvLines(file)) {
            if (!lines.next()) {
                throw new InputException("cannot read " + file + ": it is empty; its first line must name the columns");
            }
            List<String> header = lines.fields().stream().map(String::strip).toList();
            for (String name : required) {
                if (!header.contains(name)) {
                    throw new InputException("cannot use " + file + ": it has no column " + name + "; needed: "
                            + String.join(",", required));
                }
            }
            return rows(file, lines, header, required);
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private static List<Map<String, String>> rows(Path file, CsvLines lines, List<String> header, List<String> required)
            throws IOException {
        List<Map<String, String>> rows = new ArrayList<>();
        while (lines.next()) {
            List<String> fields = lines.fields();
            if (fields.size() != header.size() || rows.size() == MOST_ROWS) {
                throw new InputException("cannot use " + file + ", line " + lines.number() + ": "
                        + (rows.size() == MOST_ROWS
                                ? "more than " + MOST_ROWS + " rows; split it"
                                : fields.size() + " fields, but the header has " + header.size()));
            }
            Map<String, String> row = new LinkedHashMap<>();
            required.forEach(
                    name -> row.put(name, fields.get(header.indexOf(name)).strip()));
            rows.add(row);
        }
        if (rows.isEmpty()) {
            throw new InputException("cannot use " + file + ": it has a header but no row");
        }
        return rows;
    }
}
