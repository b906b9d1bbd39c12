package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class AtomicFileTest {
    private static final byte[] NEW = "new".getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

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
        assertThat(names()).containsExactly("out.txt");
    }

    @Test
    void aFileThatAppearsMeanwhileStays() throws IOException {
        Path target = folder.resolve("out.txt");
        assertThatThrownBy(() ->
                        AtomicFile.write(target, Overwrite.REFUSE, stream -> Files.writeString(target, "other's")))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("--force");
        assertThat(target).hasContent("other's");
        assertThat(names()).containsExactly("out.txt");
    }

    @Test
    void devicesAreWrittenDirectly() {
        Path device = Path.of("/dev/null");
        assumeTrue(Files.exists(device), "needs /dev/null");
        AtomicFile.checkWritable(device, Overwrite.REFUSE);
        write(device, Overwrite.REFUSE);
        assertThat(device).exists();
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
}
