package sunbeam.app.files.input;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import de.siegmar.fastcsv.reader.CsvRecordHandler;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;
import java.io.BufferedInputStream;
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
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.units.Decimals;

/**
 * Pairs of directions from comma-separated text (RFC 4180) with a header row, all with a wavelength or all without; other columns and blank
 * lines are skipped. At most 10 million rows of 65,536 characters.
 *
 * @param rows at least one: angles in degrees, wavelength in nm
 * @param turnDegrees of the patch about the normal, counterclockwise as seen from outside
 */
public record DirectionList(List<String> columns, List<double[]> rows, double turnDegrees) {
    private static final List<String> ANGLES = List.of("theta_i", "phi_i", "theta_r", "phi_r");
    private static final String WAVELENGTH = "wavelength";
    // At the horizon the radiance of a finite power is infinite.
    private static final double LARGEST_THETA = 89.999;
    // A hundred turns, as for the light's azimuth.
    private static final int LARGEST_PHI = 36_000;
    private static final int MOST_ROWS = 10_000_000;
    private static final int LONGEST_ROW = 1 << 16;

    /** Reads a file, or standard input if it is "-"; throws InputException with line, column and value if it cannot be used. */
    public static DirectionList read(Path file) {
        InputException.refuseIf(Files.isDirectory(file), "cannot read " + file + ": it is a folder; name a file in it");
        return InputException.naming(
                file, () -> read(file.equals(Path.of("-")) ? System.in : Files.newInputStream(file)));
    }

    private static DirectionList read(InputStream bytes) throws IOException {
        try (BufferedInputStream stream = new BufferedInputStream(bytes);
                CsvReader<CsvRecord> reader = reader(stream, separator(stream))) {
            Iterator<CsvRecord> records = reader.stream()
                    .filter(record ->
                            record.getFieldCount() > 1 || !record.getField(0).isBlank())
                    .iterator();
            InputException.refuseIf(!records.hasNext(), "it is empty; its first line must name the columns");
            List<String> header =
                    records.next().getFields().stream().map(String::strip).toList();
            List<String> columns = columns(header);
            return new DirectionList(columns, rows(records, header, columns), 0);
        } catch (CsvParseException broken) {
            throw new InputException(broken.getMessage() + "; is this a table?", broken);
        } catch (UncheckedIOException failure) {
            throw failure.getCause();
        }
    }

    /** Reads Excel's line of the separator, if there is one. */
    private static char separator(BufferedInputStream stream) throws IOException {
        stream.mark(SeparatorLine.LONGEST);
        byte[] head = stream.readNBytes(SeparatorLine.LONGEST);
        Optional<String> line = SeparatorLine.of(new String(head, StandardCharsets.UTF_8));
        stream.reset();
        stream.skipNBytes(
                line.map(text -> text.getBytes(StandardCharsets.UTF_8).length).orElse(0));
        return line.map(SeparatorLine::separator).orElse(',');
    }

    /** Malformed bytes become replacement characters: harmless in skipped columns, no numbers in others. */
    private static CsvReader<CsvRecord> reader(InputStream stream, char separator) {
        return CsvReader.builder()
                .fieldSeparator(separator)
                .detectBomHeader(true)
                .allowUnclosedQuote(false)
                // readRows() counts fields for a better message.
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

    private static List<String> columns(List<String> header) {
        List<String> columns = new ArrayList<>(ANGLES);
        if (header.contains(WAVELENGTH)) {
            columns.add(WAVELENGTH);
        }
        for (String name : columns) {
            if (!header.contains(name)) {
                String remedy = header.size() == 1 && header.get(0).matches(".*[;\\t].*")
                        ? "; separate columns by commas, not by semicolons or tabs, and write decimals with points"
                        : "; needed: " + String.join(",", ANGLES);
                throw new InputException(
                        "it has no column " + name + ", only " + abbreviated(String.join(",", header)) + remedy);
            }
            InputException.refuseIf(
                    header.indexOf(name) != header.lastIndexOf(name), "it has two columns " + name + "; remove one");
        }
        return columns;
    }

    private static List<double[]> rows(Iterator<CsvRecord> records, List<String> header, List<String> columns) {
        List<double[]> rows = new ArrayList<>();
        while (records.hasNext()) {
            CsvRecord record = records.next();
            String place = "line " + record.getStartingLineNumber();
            InputException.refuseIf(rows.size() == MOST_ROWS, "more than " + MOST_ROWS + " rows; split it");
            if (record.getFieldCount() != header.size()) {
                throw new InputException(
                        place + ": " + record.getFieldCount() + " fields, but the header has " + header.size());
            }
            rows.add(columns.stream()
                    .mapToDouble(name ->
                            number(place + ", column " + name + ": ", name, record.getField(header.indexOf(name))))
                    .toArray());
        }
        InputException.refuseIf(rows.isEmpty(), "it has a header but no row");
        return rows;
    }

    private static double number(String place, String column, String field) {
        double value = Decimals.parse(field)
                .orElseThrow(() -> new InputException(place + "'" + abbreviated(field) + "' is not a finite number"));
        if (column.startsWith("theta")) {
            String remedy = " degrees; on the other side of the normal phi differs by 180";
            requireWithin(place, value, 0, LARGEST_THETA, "0.." + LARGEST_THETA + remedy);
        } else if (column.startsWith("phi")) {
            requireWithin(place, value, -LARGEST_PHI, LARGEST_PHI, "-" + LARGEST_PHI + ".." + LARGEST_PHI + " degrees");
        } else {
            requireWithin(place, value, CieTable.FIRST_NANOMETER - 1e-6, CieTable.LAST_NANOMETER + 1e-6, "380..780 nm");
        }
        return value;
    }

    private static void requireWithin(String place, double value, double least, double most, String words) {
        if (!(value >= least && value <= most)) {
            throw new InputException(place + value + " must lie in " + words);
        }
    }

    private static String abbreviated(String text) {
        return text.length() <= 80 ? text : text.substring(0, 80) + "...";
    }

    /** Returns the directions relative to the patch rotated further, counterclockwise as seen from outside. */
    public DirectionList seenByTurned(double radians) {
        return new DirectionList(columns, rows, turnDegrees + Math.toDegrees(radians));
    }

    public int size() {
        return rows.size();
    }

    public boolean spectral() {
        return columns.contains(WAVELENGTH);
    }

    /** Angles in degrees and, in a spectral list, nanometers. */
    public double[] row(int index) {
        return rows.get(index).clone();
    }

    public DirectionPair pair(int index) {
        double[] cells = rows.get(index);
        return new DirectionPair(
                Direction.ofDegrees(cells[0], cells[1] - turnDegrees),
                Direction.ofDegrees(cells[2], cells[3] - turnDegrees));
    }

    public double wavelength(int index) {
        return rows.get(index)[4] * 1e-9;
    }

    public List<DirectionPair> pairs() {
        return IntStream.range(0, size()).mapToObj(this::pair).toList();
    }
}
