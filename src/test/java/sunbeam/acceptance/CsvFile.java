package sunbeam.acceptance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Comma-separated numbers under a header, read and written without the program's own code. */
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

    /** Returns the first rows. */
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
}
