package sunbeam.app.cli.figures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.files.input.InputException;

/** Response over the angle at one wavelength, as evaluate writes it; angles in degrees, the largest value being 1. */
record Response(double[] angles, double[] values) {
    static Response read(Figure.Drawing drawing) {
        Path file = drawing.beside(".csv");
        try {
            List<String> lines = Files.readAllLines(file);
            double[] values = numbers(lines.get(1));
            double largest = Arrays.stream(values).max().orElseThrow();
            return new Response(
                    numbers(lines.get(0)),
                    Arrays.stream(values).map(value -> value / largest).toArray());
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private static double[] numbers(String line) {
        return Stream.of(line.split(",", -1))
                .skip(1)
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    /** Returns the width of the largest maximum at half of its height. */
    double width() {
        int top = IntStream.range(0, values.length)
                .filter(i -> values[i] == 1)
                .findFirst()
                .orElseThrow();
        int left = top;
        while (left > 0 && values[left] >= 0.5) {
            left--;
        }
        int right = top;
        while (right < values.length - 1 && values[right] >= 0.5) {
            right++;
        }
        return angles[right] - angles[left];
    }
}
