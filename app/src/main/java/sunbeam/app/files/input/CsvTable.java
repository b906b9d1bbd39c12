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
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import sunbeam.precompute.units.Decimals;

/**
 * Named columns of finite numbers from comma-separated text with a header row. Columns that were not asked for are
 * skipped and may hold anything. Fields may be quoted (RFC 4180). Blank lines count for nothing. At most 10 million rows
 * of at most 65,536 characters.
 */
public final class CsvTable {
    private static final int MOST_ROWS = 10_000_000;
    private static final int LONGEST_ROW = 1 << 16;

    private final Path file;
    private final int rows;
    private final Map<String, double[]> columns;
    private final long[] lineNumbers;

    private CsvTable(Path file, int rows, Map<String, double[]> columns, long[] lineNumbers) {
        this.file = file;
        this.rows = rows;
        this.columns = columns;
        this.lineNumbers = lineNumbers;
    }

    /**
     * Reads a table.
     *
     * @param required columns that must be there
     * @param optional columns that are read where they are there
     * @throws InputException when the file is missing, has no header or no row, lacks a required column, names a wanted
     *     one twice, or has a row of another length or a wanted field that is not a finite number
     */
    public static CsvTable read(Path file, List<String> required, List<String> optional) {
        if (Files.isDirectory(file)) {
            throw new InputException("cannot read " + file + ": it is a folder; name a file in it");
        }
        try (CsvReader<CsvRecord> reader = reader(Files.newInputStream(file))) {
            Iterator<CsvRecord> records =
                    reader.stream().filter(record -> !isBlank(record)).iterator();
            if (!records.hasNext()) {
                throw new InputException("cannot read " + file + ": it is empty; its first line must name the columns");
            }
            List<String> header =
                    records.next().getFields().stream().map(String::strip).toList();
            return readRows(file, records, header.size(), wantedColumns(file, header, required, optional));
        } catch (CsvParseException broken) {
            throw new InputException("cannot use " + file + ": " + broken.getMessage() + "; is this a table?", broken);
        } catch (UncheckedIOException failure) {
            throw InputException.of(file, failure.getCause());
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    /** Malformed bytes become replacement characters: harmless in columns that nobody wants, no number elsewhere. */
    private static CsvReader<CsvRecord> reader(InputStream stream) {
        return CsvReader.builder()
                .detectBomHeader(true)
                .allowUnclosedQuote(false)
                // Counted here, so that the message can say how many there should be.
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

    /** Number of rows, at least 1. */
    public int rows() {
        return rows;
    }

    public boolean has(String column) {
        return columns.containsKey(column);
    }

    /** A copy of a column, one value for each row. */
    public double[] column(String name) {
        return columns.get(name).clone();
    }

    /** The value in a row (from 0) and column. */
    public double at(int row, String column) {
        return columns.get(column)[row];
    }

    /**
     * A complaint about one value, for checks that only the caller can make.
     *
     * @param remedy what the value must be, for example {@code must lie in 0..90}
     */
    public InputException failure(int row, String column, String remedy) {
        return fieldFailure(file, lineNumbers[row], column, Double.toString(at(row, column)), remedy);
    }

    /** Position in the header of each wanted column that is there. */
    private static Map<String, Integer> wantedColumns(
            Path file, List<String> header, List<String> required, List<String> optional) {
        Map<String, Integer> positions = new LinkedHashMap<>();
        Stream.concat(required.stream(), optional.stream())
                .filter(name -> position(file, header, name) >= 0)
                .forEach(name -> positions.put(name, position(file, header, name)));
        for (String name : required) {
            if (!positions.containsKey(name)) {
                String remedy = header.size() == 1 && header.get(0).contains(";")
                        ? "; separate columns by commas, not by semicolons"
                        : "; needed: " + String.join(",", required);
                throw new InputException("cannot use " + file + ": it has no column " + name + ", only "
                        + abbreviated(String.join(",", header)) + remedy);
            }
        }
        return positions;
    }

    private static int position(Path file, List<String> header, String name) {
        int position = header.indexOf(name);
        if (position != header.lastIndexOf(name)) {
            throw new InputException("cannot use " + file + ": it has two columns " + name + "; remove one");
        }
        return position;
    }

    private static CsvTable readRows(
            Path file, Iterator<CsvRecord> records, int width, Map<String, Integer> positions) {
        Map<String, DoubleStream.Builder> columns = new LinkedHashMap<>();
        positions.keySet().forEach(name -> columns.put(name, DoubleStream.builder()));
        LongStream.Builder lines = LongStream.builder();
        int rows = 0;
        while (records.hasNext()) {
            CsvRecord record = records.next();
            long line = record.getStartingLineNumber();
            if (rows == MOST_ROWS) {
                throw new InputException("cannot use " + file + ": more than " + MOST_ROWS + " rows; split it");
            }
            if (record.getFieldCount() != width) {
                throw new InputException("cannot use " + file + ", line " + line + ": " + record.getFieldCount()
                        + " fields, but the header has " + width);
            }
            positions.forEach(
                    (name, position) -> columns.get(name).add(number(file, line, name, record.getField(position))));
            lines.add(line);
            rows++;
        }
        if (rows == 0) {
            throw new InputException("cannot use " + file + ": it has a header but no row");
        }
        Map<String, double[]> values = new LinkedHashMap<>();
        columns.forEach((name, column) -> values.put(name, column.build().toArray()));
        return new CsvTable(file, rows, values, lines.build().toArray());
    }

    private static double number(Path file, long line, String column, String field) {
        OptionalDouble value = Decimals.parse(field);
        if (value.isEmpty()) {
            throw fieldFailure(file, line, column, "'" + abbreviated(field) + "'", "is not a finite number");
        }
        return value.getAsDouble();
    }

    private static InputException fieldFailure(Path file, long line, String column, String value, String remedy) {
        return new InputException(
                "cannot use " + file + ", line " + line + ", column " + column + ": " + value + " " + remedy);
    }

    private static String abbreviated(String text) {
        return text.length() <= 80 ? text : text.substring(0, 80) + "...";
    }
}
