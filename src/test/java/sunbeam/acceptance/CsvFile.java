package sunbeam.acceptance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

public record CsvFile(List<String> header, List<double[]> rows) {
    public static CsvFile read(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        return new CsvFile(
                List.of(lines.get(0).split(",", -1)),
                lines.stream()
                        .skip(1)
                        .map(line -> Stream.of(line.split(",", -1))
                                .mapToDouble(Double::parseDouble)
                                .toArray())
                        .toList());
    }

    /** Returns rows of four angles, or of four angles and a wavelength in nanometers. */
    public static CsvFile ofDirections(List<double[]> rows) {
        return new CsvFile(
                List.of("theta_i", "phi_i", "theta_r", "phi_r", "wavelength").subList(0, rows.get(0).length), rows);
    }

    public CsvFile head(int count) {
        return new CsvFile(header, rows.subList(0, count));
    }

    public CsvFile write(Path file) throws IOException {
        String text = rows.stream()
                .map(row -> java.util.Arrays.stream(row)
                        .mapToObj(value -> String.format(Locale.ROOT, "%.12g", value))
                        .collect(Collectors.joining(",")))
                .collect(Collectors.joining("\n", String.join(",", header) + "\n", "\n"));
        Files.writeString(file, text);
        return this;
    }

    /**
     * Returns the errors of these rows: the largest difference of the columns relative to the largest exact value, where there is light.
     *
     * @param exact rows of the same directions
     * @param nameInExact function from a column's name to its name there
     */
    public ErrorStatistics errors(CsvFile exact, UnaryOperator<String> nameInExact, String... columns) {
        return Comparison.relative(IntStream.range(0, exact.size())
                .mapToObj(row -> new Comparison(
                        Stream.of(columns)
                                .mapToDouble(column -> at(row, column))
                                .toArray(),
                        Stream.of(columns)
                                .mapToDouble(column -> exact.at(row, nameInExact.apply(column)))
                                .toArray(),
                        1))
                .toList());
    }

    public int size() {
        return rows.size();
    }

    public double at(int row, String column) {
        int index = header.indexOf(column);
        if (index < 0) {
            throw new AssertionError("no column " + column + " among " + header);
        }
        return rows.get(row)[index];
    }

    public double[] radiance(int row) {
        return Stream.of("X", "Y", "Z")
                .mapToDouble(column -> at(row, "gain") * at(row, column))
                .toArray();
    }
}
