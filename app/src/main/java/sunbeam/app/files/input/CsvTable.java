package sunbeam.app.files.input;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import de.siegmar.fastcsv.reader.CsvRecordHandler;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.units.Decimals;

/**
 * Table of named columns of finite numbers, from comma-separated text with a header row. Columns that are not requested are skipped and may
 * hold anything. Fields may be quoted (RFC 4180). Blank lines are ignored. A file may have at most 10 million rows of at most 65,536
 * characters.
 *
 * @param columns the requested columns that the file has
 * @param rows values of each row, one per column; at least one row
 */
public record CsvTable(List<String> columns, List<double[]> rows) {
    private static final int MOST_ROWS = 10_000_000;
    private static final int LONGEST_ROW = 1 << 16;

    public interface Limits {
        /** Returns a complaint about a value, for example {@code must lie in 0..90}; empty if it is in range. */
        Optional<String> complaint(String column, double value);
    }

    /**
     * Reads a table.
     *
     * @throws InputException if the file is missing, or lacks a header, a row, a requested column or a requested finite number within the
     *     limits; also if a requested column occurs twice or a row has another length
     */
    public static CsvTable read(Path file, List<String> required, List<String> optional, Limits limits) {
        if (Files.isDirectory(file)) {
            throw new InputException("cannot read " + file + ": it is a folder; name a file in it");
        }
        return InputException.naming(file, () -> read(Files.newInputStream(file), required, optional, limits));
    }

    private static CsvTable read(InputStream stream, List<String> required, List<String> optional, Limits limits)
            throws IOException {
        try (CsvReader<CsvRecord> reader = reader(stream)) {
            Iterator<CsvRecord> records =
                    reader.stream().filter(record -> !isBlank(record)).iterator();
            if (!records.hasNext()) {
                throw new InputException("it is empty; its first line must name the columns");
            }
            List<String> header =
                    records.next().getFields().stream().map(String::strip).toList();
            List<String> columns = wantedColumns(header, required, optional);
            return new CsvTable(columns, readRows(records, header, columns, limits));
        } catch (CsvParseException broken) {
            throw new InputException(broken.getMessage() + "; is this a table?", broken);
        } catch (UncheckedIOException failure) {
            throw failure.getCause();
        }
    }

    /**
     * Returns a reader in which malformed bytes become replacement characters. They are harmless in skipped columns, and no numbers in the
     * others.
     */
    private static CsvReader<CsvRecord> reader(InputStream stream) {
        return CsvReader.builder()
                .detectBomHeader(true)
                .allowUnclosedQuote(false)
                // readRows() counts fields, so that its message can name the expected count.
                .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
                .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
                .maxBufferSize(2 * LONGEST_ROW)
                .build(
                        CsvRecordHandler.of(limits -> limits.maxFields(LONGEST_ROW)
                                .maxFieldSize(LONGEST_ROW)
                                .maxRecordSize(LONGEST_ROW)),
                        stream,
                        StandardCharsets.UTF_8);
    }

    private static boolean isBlank(CsvRecord record) {
        return record.getFieldCount() == 1 && record.getField(0).isBlank();
    }

    private static List<String> wantedColumns(List<String> header, List<String> required, List<String> optional) {
        List<String> columns = Stream.concat(required.stream(), optional.stream())
                .filter(name -> position(header, name) >= 0)
                .toList();
        for (String name : required) {
            if (!columns.contains(name)) {
                String remedy = header.size() == 1 && header.get(0).matches(".*[;\\t].*")
                        ? "; separate columns by commas, not by semicolons or tabs, and write decimals with points"
                        : "; needed: " + String.join(",", required);
                throw new InputException(
                        "it has no column " + name + ", only " + abbreviated(String.join(",", header)) + remedy);
            }
        }
        return columns;
    }

    private static int position(List<String> header, String name) {
        int position = header.indexOf(name);
        if (position != header.lastIndexOf(name)) {
            throw new InputException("it has two columns " + name + "; remove one");
        }
        return position;
    }

    private static List<double[]> readRows(
            Iterator<CsvRecord> records, List<String> header, List<String> columns, Limits limits) {
        List<double[]> rows = new ArrayList<>();
        while (records.hasNext()) {
            CsvRecord record = records.next();
            String place = "line " + record.getStartingLineNumber();
            if (rows.size() == MOST_ROWS) {
                throw new InputException("more than " + MOST_ROWS + " rows; split it");
            }
            if (record.getFieldCount() != header.size()) {
                throw new InputException(
                        place + ": " + record.getFieldCount() + " fields, but the header has " + header.size());
            }
            rows.add(columns.stream()
                    .mapToDouble(name -> number(place, name, record.getField(header.indexOf(name)), limits))
                    .toArray());
        }
        if (rows.isEmpty()) {
            throw new InputException("it has a header but no row");
        }
        return rows;
    }

    private static double number(String place, String column, String field, Limits limits) {
        OptionalDouble value = Decimals.parse(field);
        String of = place + ", column " + column + ": ";
        if (value.isEmpty()) {
            throw new InputException(of + "'" + abbreviated(field) + "' is not a finite number");
        }
        limits.complaint(column, value.getAsDouble()).ifPresent(complaint -> {
            throw new InputException(of + value.getAsDouble() + " " + complaint);
        });
        return value.getAsDouble();
    }

    private static String abbreviated(String text) {
        return text.length() <= 80 ? text : text.substring(0, 80) + "...";
    }
}
