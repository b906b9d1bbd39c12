package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.text.Text;

class CsvWriterTest {
    @Test
    void numbersHaveThirteenDigitsRoundedAsByFormat() throws IOException {
        Random random = new Random(1);
        double[] values = DoubleStream.concat(
                        DoubleStream.of(
                                0, -0.0, 1, Math.nextUp(-10.0), Math.nextDown(1e100), Double.MIN_VALUE, 1e-9, 1e10),
                        DoubleStream.generate(() -> random.nextGaussian() * Math.pow(10, random.nextInt(80) - 60))
                                .limit(1000))
                .toArray();
        String expected = DoubleStream.of(values)
                .mapToObj(value -> Text.format("%.12e", value))
                .collect(Collectors.joining("\n", "a\n", "\n"));

        ByteArrayOutputStream written = new ByteArrayOutputStream();
        CsvWriter.numbers(List.of("a"), values.length, row -> new double[] {values[row]})
                .writeTo(written);

        assertThat(written.toString(StandardCharsets.UTF_8)).isEqualTo(expected);
    }
}
