package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Temporary files of processes that were killed go; those of others at work stay. */
final class AbandonedFilesTest {
    /** Above the largest number that Linux gives to a process (2^22). */
    private static final long NO_PROCESS = 99_999_999;

    private static final long THIS_PROCESS = ProcessHandle.current().pid();

    @TempDir
    private Path folder;

    private String here;

    @BeforeEach
    void knowThisMachine() {
        here = AbandonedFiles.machine();
    }

    private Path part(String machine, long process, Duration age) throws IOException {
        Path file = Files.writeString(folder.resolve(".sunbeam-" + machine + process + "-0.part"), "half");
        return Files.setLastModifiedTime(file, FileTime.from(Instant.now().minus(age)));
    }

    private void writeAnother() {
        AtomicFile.checkWritable(folder.resolve("out"), Overwrite.REFUSE);
    }

    @Test
    void aDeadProcessesFileGoesAtTheNextStart() throws IOException {
        assumeTrue(!here.equals("00000000"), "skipped: this system does not tell its processes from others'");
        Path dead = part(here + "-", NO_PROCESS, Duration.ZERO);
        writeAnother();
        assertThat(dead).doesNotExist();
    }

    @Test
    void aFileThatIsBeingWrittenStays() throws IOException {
        Path living = part(here + "-", THIS_PROCESS, Duration.ZERO);
        writeAnother();
        assertThat(living).exists();
    }

    @Test
    void aNumberThatWasGivenAgainIsNoExcuse() throws IOException {
        assumeTrue(!here.equals("00000000"), "skipped: this system does not tell its processes from others'");
        assumeTrue(ProcessHandle.current().info().startInstant().isPresent(), "skipped: no starting times here");
        Path before = part(here + "-", THIS_PROCESS, Duration.ofDays(3650));
        writeAnother();
        assertThat(before).doesNotExist();
    }

    @Test
    void filesOfAnotherMachineStayForAWeek() throws IOException {
        Path young = part("12345678-", NO_PROCESS, Duration.ofDays(6));
        Path old = part("87654321-", NO_PROCESS, Duration.ofDays(8));
        Path former = part("", NO_PROCESS, Duration.ofDays(8));
        writeAnother();
        assertThat(young).exists();
        assertThat(old).doesNotExist();
        assertThat(former).doesNotExist();
    }

    @Test
    void whatIsNotSunbeamsStays() throws IOException {
        Path other = Files.writeString(folder.resolve(".sunbeam-notes.part"), "mine");
        Path directory = Files.createDirectory(folder.resolve(".sunbeam-" + here + "-" + NO_PROCESS + "-0.part"));
        Files.setLastModifiedTime(other, FileTime.fromMillis(0));
        writeAnother();
        assertThat(other).exists();
        assertThat(directory).exists();
    }
}
