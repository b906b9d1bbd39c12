package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

final class CsvWriterTest {
    @Test
    void numbersAreWrittenAlikeInAllLocales() throws IOException {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            ByteArrayOutputStream stream = new ByteArrayOutputStream();
            double[][] rows = {{75, 1.0 / 3}, {-0.5, Double.NaN}};
            CsvWriter.numbers(List.of("theta_i", "power"), 2, row -> rows[row]).writeTo(stream);
            assertThat(stream.toString(StandardCharsets.UTF_8))
                    .isEqualTo("theta_i,power\n7.500000000000e+01,3.333333333333e-01\n-5.000000000000e-01,NaN\n");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void thirteenDigitsComeBack() throws IOException {
        double[] values = {Math.PI, -1.2345678901234567e-200, Double.MAX_VALUE / 3, 0};
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        CsvWriter.numbers(List.of("x"), values.length, row -> new double[] {values[row]})
                .writeTo(stream);
        List<String> read = stream.toString(StandardCharsets.UTF_8).lines().toList();
        for (int row = 0; row < values.length; row++) {
            assertThat(Double.parseDouble(read.get(row + 1)))
                    .isCloseTo(values[row], withinPercentage(5e-11)); // half of the 13th digit
        }
    }
}
