package sunbeam.app.measure.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class ExactJournalTest {
    private static final List<double[]> VALUES =
            List.of(new double[] {1.0 / 3, -2e-300, Double.MIN_VALUE}, new double[0], new double[] {4});

    @TempDir
    private Path folder;

    private int computed;

    private List<double[]> batch(String key) {
        return ExactJournal.of(file()).batch(key, () -> {
            computed++;
            return VALUES;
        });
    }

    private Path file() {
        return folder.resolve("exact-values.txt");
    }

    @Test
    void whatWasComputedIsReadToTheLastBit() {
        batch("a");
        List<double[]> again = batch("a");

        assertThat(computed).isEqualTo(1);
        assertThat(again).hasSize(3);
        for (int row = 0; row < 3; row++) {
            assertThat(again.get(row)).containsExactly(VALUES.get(row));
        }
    }

    @Test
    void anotherKeyIsComputed() {
        batch("a");
        batch("b");
        batch("a");
        assertThat(computed).isEqualTo(2);
    }

    /** A process that was killed leaves any part of its last line. */
    @Test
    void aLineThatWasCutOffIsComputedAgainAndHarmsNoOther() throws IOException {
        batch("a");
        long first = Files.size(file());
        batch("b");
        byte[] whole = Files.readAllBytes(file());
        for (int length = (int) first; length < whole.length - 1; length++) {
            Files.write(file(), java.util.Arrays.copyOf(whole, length));
            computed = 0;
            batch("a");
            batch("b");
            assertThat(computed)
                    .as("batches computed after a cut at byte %s", length)
                    .isEqualTo(1);
            batch("b");
            assertThat(computed).isEqualTo(1);
        }
    }

    @Test
    void aFlippedBitIsFound() throws IOException {
        batch("a");
        String text = Files.readString(file(), StandardCharsets.ISO_8859_1);
        Files.writeString(file(), text.replace("0.333", "0.334"), StandardCharsets.ISO_8859_1);
        batch("a");
        assertThat(computed).isEqualTo(2);
    }
}
