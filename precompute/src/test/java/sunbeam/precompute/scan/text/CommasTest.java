package sunbeam.precompute.scan.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanException;

/** Commas are decimal marks, or separators. */
class CommasTest {
    @TempDir
    private Path folder;

    private double[] read(String text) throws IOException {
        return read(text, Optional.empty());
    }

    private double[] read(String text, Optional<DecimalMark> mark) throws IOException {
        Path file = folder.resolve("scan.txt");
        Files.writeString(file, text);
        try (ScanBytes opened = ScanBytes.open(file)) {
            TextNumbers numbers =
                    TextNumbers.read(TextFile.of(opened, mark).orElseThrow().numbers());
            numbers.requireRectangular();
            assertThat(numbers.rows()).isEqualTo(2);
            return numbers.all();
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "1,5 -2,25\n3 4,75\n",
                "1,5;-2,25\n3;4,75\n",
                "1,5, -2,25\n3, 4,75\n",
                "1,5, -2,25,\n3, 4,75,\n",
                "1,5,\t-2,25\r\n3,\t4,75\r\n",
                "1.5,-2.25\n3,4.75\n",
                "1.5, -2.25\n3, 4.75\n"
            })
    void fourNumbersAreReadHoweverTheyAreWritten(String text) throws IOException {
        assertThat(read(text)).containsExactly(1.5, -2.25, 3, 4.75);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1,5,-2,25\n3,0,4,75\n", "1, 5, -2, 25\n3, 0, 4, 75\n"})
    void commasBetweenWholeNumbersSeparateThem(String text) throws IOException {
        assertThat(read(text)).containsExactly(1, 5, -2, 25, 3, 0, 4, 75);
    }

    @Test
    void whoeverSaysTheMarkIsBelieved() throws IOException {
        assertThat(read("1,5 2,5\n3,5 4,5\n", Optional.of(DecimalMark.POINT))).containsExactly(1, 5, 2, 5, 3, 5, 4, 5);
        assertThat(read("1,5\n2,5\n", Optional.of(DecimalMark.COMMA))).containsExactly(1.5, 2.5);
        assertThatThrownBy(() -> read("1 2\n3 4,x\n", Optional.empty()))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("\"x\" in line 2");
    }
}
