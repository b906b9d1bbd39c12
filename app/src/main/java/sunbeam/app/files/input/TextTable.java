package sunbeam.app.files.input;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.UncheckedIOException;
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
        List<Map<String, String>> rows = new ArrayList<>();
        try (CsvReader<NamedCsvRecord> records = CsvReader.builder()
                .detectBomHeader(true)
                .allowUnclosedQuote(false)
                .extraFieldStrategy(FieldMismatchStrategy.STRICT)
                .missingFieldStrategy(FieldMismatchStrategy.STRICT)
                .ofNamedCsvRecord(file)) {
            for (NamedCsvRecord each : records) {
                if (rows.size() == MOST_ROWS) {
                    throw new InputException("cannot use " + file + ": more than " + MOST_ROWS + " rows; split it");
                }
                rows.add(row(file, each, required));
            }
        } catch (CsvParseException broken) {
            throw new InputException("cannot use " + file + ": " + broken.getMessage() + "; is this a table?", broken);
        } catch (UncheckedIOException failure) {
            throw InputException.of(file, failure.getCause());
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
        if (rows.isEmpty()) {
            throw new InputException(
                    "cannot use " + file + ": it has no row below a header; needed: " + String.join(",", required));
        }
        return rows;
    }

    private static Map<String, String> row(Path file, NamedCsvRecord each, List<String> required) {
        Map<String, String> row = new LinkedHashMap<>();
        for (String name : required) {
            String field = each.findField(name)
                    .orElseThrow(() -> new InputException("cannot use " + file + ": it has no column " + name
                            + "; needed: " + String.join(",", required)));
            row.put(name, field.strip());
        }
        return row;
    }
}
