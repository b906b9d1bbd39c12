package sunbeam.app.input;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import sunbeam.precompute.units.Decimals;

/**
 * Named columns of finite numbers from comma-separated text with a header row. Columns that were not asked for are
 * skipped and may hold anything. Fields may be quoted; a quoted field does not cross lines. Blank lines count for
 * nothing. At most 10 million rows of at most 65,536 characters.
 */
public final class CsvTable {
    private static final int MOST_ROWS = 10_000_000;

    private final Path file;
    private final int rows;
    private final Map<String, double[]> columns;
    private final int[] lineNumbers;

    private CsvTable(Path file, int rows, Map<String, double[]> columns, int[] lineNumbers) {
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
        try (CsvLines lines = new CsvLines(file)) {
            if (!lines.next()) {
                throw new InputException("cannot read " + file + ": it is empty; its first line must name the columns");
            }
            List<String> header = lines.fields().stream().map(String::strip).toList();
            return readRows(file, lines, header.size(), wantedColumns(file, header, required, optional));
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    /** Number of rows, at least 1. */
    public int rows() {
        return rows;
    }

    /** Names of the columns that were asked for and are there. */
    public Set<String> columns() {
        return columns.keySet();
    }

    public boolean has(String column) {
        return columns.containsKey(column);
    }

    /** A copy of a column, one value for each row. */
    public double[] column(String name) {
        return present(name).clone();
    }

    /** The value in a row (from 0) and column. */
    public double at(int row, String column) {
        return present(column)[row];
    }

    /**
     * A complaint about one value, for checks that only the caller can make.
     *
     * @param remedy what the value must be, for example {@code must lie in 0..90}
     */
    public InputException failure(int row, String column, String remedy) {
        return fieldFailure(file, lineNumbers[row], column, Double.toString(at(row, column)), remedy);
    }

    private double[] present(String column) {
        double[] values = columns.get(column);
        if (values == null) {
            throw new IllegalArgumentException("no column " + column + " was read from " + file);
        }
        return values;
    }

    /** Position in the header of each wanted column that is there. */
    private static Map<String, Integer> wantedColumns(
            Path file, List<String> header, List<String> required, List<String> optional) {
        Map<String, Integer> positions = new LinkedHashMap<>();
        for (String name : required) {
            int position = position(file, header, name);
            if (position < 0) {
                String remedy = header.size() == 1 && header.get(0).contains(";")
                        ? "; separate columns by commas, not by semicolons"
                        : "; needed: " + String.join(",", required);
                throw new InputException("cannot use " + file + ": it has no column " + name + ", only "
                        + abbreviated(String.join(",", header)) + remedy);
            }
            positions.put(name, position);
        }
        for (String name : optional) {
            int position = position(file, header, name);
            if (position >= 0) {
                positions.put(name, position);
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

    private static CsvTable readRows(Path file, CsvLines lines, int width, Map<String, Integer> positions)
            throws IOException {
        Map<String, double[]> columns = new LinkedHashMap<>();
        positions.keySet().forEach(name -> columns.put(name, new double[16]));
        int[] lineNumbers = new int[16];
        int rows = 0;
        while (lines.next()) {
            if (rows == MOST_ROWS) {
                throw new InputException("cannot use " + file + ": more than " + MOST_ROWS + " rows; split it");
            }
            List<String> fields = lines.fields();
            if (fields.size() != width) {
                throw new InputException("cannot use " + file + ", line " + lines.number() + ": " + fields.size()
                        + " fields, but the header has " + width);
            }
            int row = rows++;
            if (row == lineNumbers.length) {
                lineNumbers = Arrays.copyOf(lineNumbers, 2 * row);
                columns.replaceAll((name, values) -> Arrays.copyOf(values, 2 * row));
            }
            lineNumbers[row] = lines.number();
            for (Map.Entry<String, Integer> wanted : positions.entrySet()) {
                String field = fields.get(wanted.getValue());
                columns.get(wanted.getKey())[row] = number(file, lines.number(), wanted.getKey(), field);
            }
        }
        if (rows == 0) {
            throw new InputException("cannot use " + file + ": it has a header but no row");
        }
        int count = rows;
        columns.replaceAll((name, values) -> Arrays.copyOf(values, count));
        return new CsvTable(file, rows, columns, lineNumbers);
    }

    private static double number(Path file, int line, String column, String field) {
        OptionalDouble value = Decimals.parse(field);
        if (value.isEmpty()) {
            throw fieldFailure(file, line, column, "'" + abbreviated(field) + "'", "is not a finite number");
        }
        return value.getAsDouble();
    }

    private static InputException fieldFailure(Path file, int line, String column, String value, String remedy) {
        return new InputException(
                "cannot use " + file + ", line " + line + ", column " + column + ": " + value + " " + remedy);
    }

    private static String abbreviated(String text) {
        return text.length() <= 80 ? text : text.substring(0, 80) + "...";
    }
}
