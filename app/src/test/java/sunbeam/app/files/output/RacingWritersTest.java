package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Several writers of one name at once: no two get the same name, and no content is lost without an error. */
final class RacingWritersTest {
    private static final int WRITERS = 4;
    /** With a check before a rename, two writers succeed in one race of nine: 200 races find it. */
    private static final int RACES = 200;

    @TempDir
    private Path folder;

    private final ExecutorService threads = Executors.newFixedThreadPool(WRITERS);

    @AfterEach
    void end() {
        threads.shutdownNow();
    }

    /** Path of each writer, or null if it was refused. */
    private List<Path> race(Path target, Overwrite overwrite) throws Exception {
        CyclicBarrier start = new CyclicBarrier(WRITERS);
        List<Future<Path>> writers = new ArrayList<>();
        for (int writer = 0; writer < WRITERS; writer++) {
            byte[] content = ("writer " + writer).getBytes(StandardCharsets.UTF_8);
            writers.add(threads.submit(() -> {
                try (AtomicFile file = AtomicFile.create(target, overwrite)) {
                    file.fill(stream -> stream.write(content));
                    start.await();
                    return file.commit();
                } catch (OutputException refused) {
                    assertThat(refused).hasMessageContaining("it exists; add --force");
                    return null;
                }
            }));
        }
        List<Path> places = new ArrayList<>();
        for (Future<Path> writer : writers) {
            places.add(writer.get());
        }
        return places;
    }

    @Test
    void onlyOneGetsANameThatMayNotBeReplaced() throws Exception {
        for (int race = 0; race < RACES; race++) {
            Path target = folder.resolve("race-" + race);
            List<Path> places = race(target, Overwrite.REFUSE);
            assertThat(places.stream().filter(Objects::nonNull)).hasSize(1);
            int winner = places.indexOf(target);
            assertThat(target).hasContent("writer " + winner);
        }
        assertThat(folder.toFile().list()).hasSize(RACES);
    }

    @Test
    void eachWriterGetsItsOwnName() throws Exception {
        for (int race = 0; race < RACES / 4; race++) {
            Path target = folder.resolve("race" + race + ".png");
            List<Path> places = race(target, Overwrite.NUMBER);
            Set<String> names = new TreeSet<>();
            for (int writer = 0; writer < WRITERS; writer++) {
                assertThat(places.get(writer)).hasContent("writer " + writer);
                names.add(places.get(writer).getFileName().toString());
            }
            assertThat(names)
                    .containsExactlyInAnyOrder(
                            "race" + race + ".png",
                            "race" + race + "-2.png",
                            "race" + race + "-3.png",
                            "race" + race + "-4.png");
        }
    }
}
