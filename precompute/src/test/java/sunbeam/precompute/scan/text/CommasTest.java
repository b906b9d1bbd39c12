package sunbeam.precompute.scan.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanException;

/** Commas are decimal marks, or separators, or both. */
class CommasTest {
    @TempDir
    private Path folder;

    private double[] read(String text) throws IOException {
        Path file = folder.resolve("scan.txt");
        Files.writeString(file, text);
        try (ScanBytes opened = ScanBytes.open(file)) {
            TextBytes bytes = TextBytes.of(opened);
            TextHead head = TextHead.of(bytes).orElseThrow();
            TextNumbers numbers = TextNumbers.count(bytes, head);
            numbers.requireRectangular();
            assertThat(numbers.rows()).isEqualTo(2);
            return numbers.read();
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
    void halvesOfNumbersAreSeenByTheirSigns() {
        String row = "-7,82,-44,55,-22,70,49,38,".repeat(10) + "35,36\n";
        assertThatThrownBy(() -> read(row + row))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("decimal marks or separators");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "200,05,198,71,99,30,101,22,", // two decimals
                "200,0,198,7,99,3,101,2,", // one
                "200,5,198,71,99,3,101,05," // as many as there are
            })
    void halvesOfPositiveNumbersAreSeenByTheirDigits(String numbers) {
        String row = numbers.repeat(9) + numbers.replaceAll(",$", "\n");
        assertThatThrownBy(() -> read(row + row))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("decimal marks or separators");
    }

    @ParameterizedTest
    @ValueSource(strings = {"7,82,144,5,22,70,149,138,", "107,182,144,155,122,170,149,138,"})
    void wholePositiveNumbersAreNoHalves(String numbers) throws IOException {
        String row = numbers.repeat(10) + "35,36\n";
        assertThat(read(row + row)).hasSize(164);
    }

    @Test
    void wholeNumbersOfEitherSignAreNoHalves() throws IOException {
        String row = "-7,82,44,-55,22,-70,-49,38,".repeat(10) + "35,36\n";
        assertThat(read(row + row)).hasSize(164);
    }
}
