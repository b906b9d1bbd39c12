package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.NullSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.UsageException;

/** Files appear whole or not at all, one by one, in groups, and of several writers at once, under names that fit their content. */
final class AtomicFileTest {
    private static final byte[] NEW = "new".getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;

    private static void write(Path target, Overwrite overwrite) {
        AtomicFile.write(target, overwrite, stream -> stream.write(NEW));
    }

    @Test
    void othersMayReadItAsAnyNewFile() throws IOException {
        Path plain = Files.createFile(folder.resolve("plain"));
        Path target = folder.resolve("out.txt");
        write(target, Overwrite.REFUSE);
        assertThat(Files.getPosixFilePermissions(target)).isEqualTo(Files.getPosixFilePermissions(plain));
    }

    @Test
    void aFileThatReplacesAPrivateOneIsPrivateFromTheStart() throws IOException {
        Path target = Files.createFile(folder.resolve("out.txt"));
        Files.setPosixFilePermissions(target, PosixFilePermissions.fromString("rw-------"));
        try (AtomicFile file = AtomicFile.create(target, Overwrite.REPLACE)) {
            assertThat(Files.getPosixFilePermissions(file.path()))
                    .isEqualTo(PosixFilePermissions.fromString("rw-------"));
            file.fill(stream -> stream.write(NEW));
            file.commit();
        }
        assertThat(target).hasBinaryContent(NEW);
        assertThat(Files.getPosixFilePermissions(target)).isEqualTo(PosixFilePermissions.fromString("rw-------"));
    }

    @Test
    void aFailureKeepsTheOldFile() throws IOException {
        Path target = Files.writeString(folder.resolve("out.txt"), "old");
        assertThatThrownBy(() -> AtomicFile.write(target, Overwrite.REPLACE, stream -> {
                    stream.write(NEW);
                    throw new IOException("No space left on device");
                }))
                .isInstanceOf(OutputException.class)
                .hasMessageContainingAll(target.toString(), "No space left on device; free some space");
        assertThat(target).hasContent("old");
        assertThat(folder.toFile().list()).containsExactly("out.txt");
    }

    @Test
    void aFileThatAppearsMeanwhileStays() throws IOException {
        Path target = folder.resolve("out.txt");
        assertThatThrownBy(() ->
                        AtomicFile.write(target, Overwrite.REFUSE, stream -> Files.writeString(target, "other's")))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("--force");
        assertThat(target).hasContent("other's");
        assertThat(folder.toFile().list()).containsExactly("out.txt");
    }

    @Test
    void aLinkIsReplacedAndNotFollowed() throws IOException {
        Path target = Files.writeString(folder.resolve("target.txt"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("link.txt"), target);
        assertThatThrownBy(() -> write(link, Overwrite.REFUSE)).isInstanceOf(OutputException.Exists.class);
        write(link, Overwrite.REPLACE);
        assertThat(link).isRegularFile().hasBinaryContent(NEW);
        assertThat(Files.isSymbolicLink(link)).isFalse();
        assertThat(target).hasContent("old");
    }

    /** In a folder that all users may write to, the link may be another user's; elsewhere it is /dev/stdout. */
    @Test
    void aLinkToADeviceIsFollowedUnlessOthersMayCreateLinks() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("link.txt"), Path.of("/dev/full"));
        assertThatThrownBy(() -> write(link, Overwrite.REPLACE)).hasMessageContaining("No space left");
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxrwxrwx"));
        assertThatThrownBy(() -> write(link, Overwrite.REFUSE)).isInstanceOf(OutputException.Exists.class);
        write(link, Overwrite.REPLACE);
        assertThat(link).isRegularFile().hasBinaryContent(NEW);
        assertThat(Files.isSymbolicLink(link)).isFalse();
    }

    /** The process of an old file was killed; other files may still be written. */
    @Test
    void temporaryFilesUnusedForADayAreDeleted() throws IOException {
        Path old = Files.createFile(folder.resolve(".sunbeam-99999999-0.part"));
        Files.setLastModifiedTime(old, FileTime.from(Instant.now().minus(Duration.ofHours(25))));
        Path young = Files.createFile(folder.resolve(".sunbeam-99999999-1.part"));
        Path other = Files.createFile(folder.resolve(".sunbeam-notes.part"));
        Files.setLastModifiedTime(other, FileTime.fromMillis(0));

        AtomicFile.checkWritable(folder.resolve("out.txt"), Overwrite.REFUSE);

        assertThat(old).doesNotExist();
        assertThat(young).exists();
        assertThat(other).exists();
    }

    private static final int WRITERS = 4;
    /** With a check before a rename, two writers succeed in one race of nine: 200 races find it. */
    private static final int RACES = 200;

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
            for (int writer = 0; writer < WRITERS; writer++) {
                assertThat(places.get(writer)).hasContent("writer " + writer);
            }
            assertThat(places.stream().map(folder::relativize).map(Path::toString))
                    .containsExactlyInAnyOrderElementsOf(Stream.of("", "-2", "-3", "-4")
                            .map(("race" + race)::concat)
                            .map(stem -> stem + ".png")
                            .toList());
        }
    }

    private static final List<String> ENDINGS = List.of(".png", ".csv", ".json");

    private static Map<String, StreamContent> contents(String text) {
        Map<String, StreamContent> contents = new LinkedHashMap<>();
        ENDINGS.forEach(ending -> contents.put(ending, stream -> stream.write(text.getBytes(StandardCharsets.UTF_8))));
        return contents;
    }

    private FileGroup group(Overwrite overwrite) {
        return new FileGroup(folder.resolve("blaze"), ENDINGS, overwrite);
    }

    @Test
    void allFilesHaveOneNumberAlsoWhereOneNameAloneIsTaken() throws IOException {
        Files.writeString(folder.resolve("blaze.csv"), "somebody's");
        Files.writeString(folder.resolve("blaze-2.json"), "somebody's");

        List<Path> places = group(Overwrite.NUMBER).write(contents("new"));

        assertThat(places)
                .extracting(place -> place.getFileName().toString())
                .containsExactly("blaze-3.png", "blaze-3.csv", "blaze-3.json");
        assertThat(folder.toFile().list())
                .containsExactlyInAnyOrder("blaze-2.json", "blaze-3.csv", "blaze-3.json", "blaze-3.png", "blaze.csv");
        assertThat(folder.resolve("blaze.csv")).hasContent("somebody's");
    }

    @Test
    void noFileAppearsIfOneMayNotBeReplaced() throws IOException {
        FileGroup group = group(Overwrite.REFUSE);
        Map<String, StreamContent> contents = contents("new");
        // Another program creates a file while the last one is written.
        contents.put(".json", stream -> Files.writeString(folder.resolve("blaze.csv"), "somebody's"));

        assertThatThrownBy(() -> group.write(contents))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("blaze.csv: it exists; add --force");
        assertThat(folder.toFile().list()).containsExactly("blaze.csv");
        assertThat(folder.resolve("blaze.csv")).hasContent("somebody's");
    }

    @ParameterizedTest
    @CsvSource({
        "PNG, map.jpg, a PNG picture, end it with .png",
        "PNG, .png.gif, a PNG picture, end it with .png",
        "PNG, scan.v1.2, a PNG picture, end it with .png",
        "MESH, a.gltf, a mesh, end it with .obj or .ply or .glb",
        "HDF5, folder.h5/q, an HDF5 file, call it q.h5",
    })
    void aNameThatSaysOtherwiseIsRefusedWithTheOnesThatWillDo(Ending ending, String name, String what, String remedy) {
        assertThatThrownBy(() -> ending.require("--output", Path.of(name)))
                .isInstanceOf(UsageException.class)
                .hasMessage("--output " + name + " would be " + what + ", which its name does not say; " + remedy);
    }

    @ParameterizedTest
    @ValueSource(strings = {"map.png", "map.PNG", "scan.v1.2.png", "folder.jpg/map.png"})
    void aNameThatEndsInPngIsAcceptedForAPngAlone(String name) {
        Ending.PNG.require("--output", Path.of(name));
        assertThatThrownBy(() -> Ending.NPZ.require("--output", Path.of(name))).isInstanceOf(UsageException.class);
    }

    @ParameterizedTest
    @NullSource
    @ValueSource(strings = {"-", "/dev/null", "/", "."})
    void standardOutputDevicesAndFoldersNeedNoEnding(String name) {
        Path named = name == null ? null : Path.of(name);
        assertThat(Ending.values()).allSatisfy(ending -> ending.require("--output", named));
    }
}
