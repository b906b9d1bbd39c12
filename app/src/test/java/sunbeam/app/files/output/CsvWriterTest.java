package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.CsvTable;

final class CsvWriterTest {
    @TempDir
    private Path folder;

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
    void thirteenDigitsComeBack() {
        Path file = folder.resolve("out.csv");
        double[] values = {Math.PI, -1.2345678901234567e-200, Double.MAX_VALUE / 3, 0};
        AtomicFile.write(file, Overwrite.REFUSE, CsvWriter.numbers(List.of("x"), values.length, row ->
                new double[] {values[row]}));
        List<double[]> read = CsvTable.read(file, List.of("x"), List.of(), (column, value) -> Optional.empty())
                .rows();
        for (int row = 0; row < values.length; row++) {
            assertThat(read.get(row)[0]).isCloseTo(values[row], withinPercentage(5e-11)); // half of the 13th digit
        }
    }
}
