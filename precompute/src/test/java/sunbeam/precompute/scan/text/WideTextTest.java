package sunbeam.precompute.scan.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;

/** What Windows calls Unicode. */
final class WideTextTest {
    private static final String TEXT =
            "# Channel: Höhe\r\n# Width: 5 \u03bcm\r\n# Height: 2,5 \u00b5m\r\n# Value units: nm\r\n1,5\t2,5\t-3\r\n4,25\t5\t6\r\n";

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"UTF-16LE, true", "UTF-16BE, true", "UTF-8, true", "UTF-8, false"})
    void isReadAsOther(String charset, boolean marked) throws IOException {
        Path path = folder.resolve("scan.txt");
        Files.write(path, ((marked ? "\ufeff" : "") + TEXT).getBytes(Charset.forName(charset)));
        try (ScanBytes bytes = ScanBytes.open(path)) {
            assertThat(new TextReader(Optional.empty()).recognises(bytes)).isTrue();
            ScanChannel channel =
                    new TextReader(Optional.empty()).channels(bytes).get(0);
            assertThat(channel.columns()).isEqualTo(3);
            assertThat(channel.rows()).isEqualTo(2);
            // Rounding of the unit's factor.
            assertThat(channel.extent().width().orElseThrow()).isCloseTo(5e-6, within(1e-20));
            assertThat(channel.unit()).isEqualTo("nm");
            assertThat(channel.samples()).containsExactly(1.5, 2.5, -3, 4.25, 5, 6);
        }
    }

    @ParameterizedTest
    @CsvSource({"0", "1", "2", "3", "7"})
    void halfACharacterIsNoNumber(int length) throws IOException {
        Path path = folder.resolve("scan.txt");
        Files.write(path, Arrays.copyOf("\ufeff1\t2".getBytes(StandardCharsets.UTF_16LE), length));
        try (ScanBytes bytes = ScanBytes.open(path)) {
            assertThat(new TextReader(Optional.empty()).recognises(bytes)).isFalse();
        }
    }
}
