package sunbeam.app.files.cache;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.table.TableLabel;

/** A table of three squares, the second of which takes two batches. */
final class KeptColorsTest {
    private static final TableLabel LABEL = new TableLabel("bläze", "half made");
    private static final int[] PLACES = {100, KeptColors.BATCH + 5, 7};
    private static final int ALL = Arrays.stream(PLACES).sum();

    @TempDir
    private Path folder;

    private int evaluated;
    private int opened;

    private Path file() {
        return folder.resolve("table.colors");
    }

    private static float[] places(int square) {
        float[] places = new float[3 * PLACES[square]];
        for (int i = 0; i < places.length; i++) {
            places[i] = square + 1e-3f * i;
        }
        return places;
    }

    /** Colors that tell places apart; after so many, the process is killed. */
    private ColorSource source(int stopAfter) {
        opened++;
        return places -> {
            if (evaluated + places.length / 3 > stopAfter) {
                throw new IllegalStateException("killed");
            }
            evaluated += places.length / 3;
            float[] xyz = places.clone();
            for (int i = 0; i < xyz.length; i++) {
                xyz[i] = (float) Math.sin(xyz[i]);
            }
            return xyz;
        };
    }

    /** Asks for all; returns how many were evaluated now. */
    private int make(String key, int stopAfter) {
        evaluated = 0;
        try (KeptColors colors = KeptColors.of(file(), key, LABEL, () -> source(stopAfter))) {
            for (int square = 0; square < PLACES.length; square++) {
                float[] xyz = colors.xyz(places(square));
                float[] places = places(square);
                for (int i = 0; i < xyz.length; i++) {
                    assertThat(xyz[i]).isEqualTo((float) Math.sin(places[i]));
                }
            }
        } catch (IllegalStateException killed) {
            assertThat(killed).hasMessage("killed");
        }
        return evaluated;
    }

    @Test
    void whatWasEvaluatedBeforeTheStopIsNotEvaluatedAgain() {
        assertThat(make("key", ALL - 8)).isEqualTo(100 + KeptColors.BATCH);
        assertThat(make("key", ALL)).isEqualTo(5 + 7);
        assertThat(opened).isEqualTo(2);
        assertThat(make("key", ALL)).isZero();
        assertThat(opened).as("nothing is uploaded where nothing is missing").isEqualTo(2);
    }

    @Test
    void anotherTablesColorsAreNotUsed() {
        make("key", ALL);
        assertThat(make("other", ALL)).isEqualTo(ALL);
        assertThat(make("other", ALL)).isZero();
    }

    /** A process may be killed at any byte: at each of some hundred, the whole records before it are used. */
    @Test
    void aRecordThatWasCutOffIsEvaluatedAgain() throws IOException {
        make("key", ALL);
        byte[] whole = Files.readAllBytes(file());
        for (int length = 0; length < whole.length; length += 1 + whole.length / 150) {
            Files.write(file(), Arrays.copyOf(whole, length));
            int again = make("key", ALL);
            assertThat(again).as("evaluated after a cut at byte %s", length).isPositive();
            assertThat(file()).as("after a cut at byte %s", length).hasBinaryContent(whole);
        }
    }
}
