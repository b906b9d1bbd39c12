package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@code ./sunbeam archive} asks of Maven, and which Java runtimes it takes. */
class ArchiveTest extends InSandbox {
    private static final int USAGE = 2;

    @Test
    void anArchiveIsNamedOnceItIsBuilt() throws Exception {
        installMaven("mkdir -p app/target && touch app/target/sunbeam-0.1.0-portable.zip");

        SunbeamResult result = command("archive").run().ended(0);
        assertThat(result.stdout().strip()).endsWith("/app/target/sunbeam-0.1.0-portable.zip");
    }

    @Test
    void anArchiveThatFailsNamesTheLog() throws Exception {
        installMaven("exit 1");

        SunbeamResult result = command("archive").run().ended(SET_UP_FAILED);
        assertThat(result.stderr()).contains("no archives were built", "launcher-build.log");
        assertThat(result.stdout()).isEmpty();
    }

    /** Machine codes: PE specification, ELF's e_machine, Mach-O's cputype. */
    @ParameterizedTest
    @CsvSource({
        "windows-x64, bin/java.exe, 64860000",
        "linux-x64, bin/java, 3e000000",
        "linux-aarch64, bin/java, b7000000",
        "macos-x64, Contents/Home/bin/java, 07000001",
        "macos-aarch64, Contents/Home/bin/java, 0c000001"
    })
    void aRuntimesSystemIsReadFromItsProgram(String system, String program, String machine) throws Exception {
        installMaven("mkdir -p app/target && touch app/target/sunbeam-0.1.0-" + system + ".zip");
        Path runtime = runtime(
                program,
                machine,
                "JAVA_VERSION=\"21.0.1\"\nMODULES=\"java.base java.desktop java.sql jdk.management jdk.unsupported\"\n");

        SunbeamResult result =
                command("archive", "--with-java", runtime.toString()).run().ended(0);
        assertThat(result.stdout().strip()).endsWith("/app/target/sunbeam-0.1.0-" + system + ".zip");
        assertThat(folder.resolve("maven calls")).content().contains("-Dsunbeam.system=" + system);
    }

    @Test
    void aRuntimeThatWillNotDoIsNamed() throws Exception {
        refused(
                "is for a system that Sunbeam has no OpenGL for (pe-64aa)",
                "bin/java.exe",
                "64aa0000",
                "JAVA_VERSION=\"17\"");
        refused(
                "is for a system that Sunbeam has no OpenGL for (elf-1500)",
                "bin/java",
                "15000000",
                "JAVA_VERSION=\"17\"");
        refused("is older than 17", "bin/java", "3e000000", "JAVA_VERSION=\"11.0.2\"");
        refused("has no java.desktop", "bin/java", "3e000000", "JAVA_VERSION=\"17\"\nMODULES=\"java.base\"");
    }

    private void refused(String reason, String program, String machine, String release) throws Exception {
        Path runtime = runtime(program, machine, release);
        SunbeamResult result =
                command("archive", "--with-java", runtime.toString()).run().ended(USAGE);
        assertThat(result.stderr()).hasLineCount(1).contains(runtime.toString(), reason);
        assertThat(builds()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"--with-java", "--with-java /nowhere", "--with-jar x", "one two three"})
    void aWrongCommandLineIsOneLine(String words) throws Exception {
        SunbeamResult result =
                command(("archive " + words).split(" ", -1)).run().ended(USAGE);
        assertThat(result.stderr()).hasLineCount(1).contains("--with-java");
        assertThat(builds()).isZero();
    }

    /** Makes a runtime whose program is the header that names the machine alone. */
    private Path runtime(String program, String machine, String release) throws IOException {
        Path runtime = Files.createTempDirectory(folder, "a runtime");
        Path file = runtime.resolve(program);
        Files.createDirectories(file.getParent());
        int code = Integer.parseUnsignedInt(machine, 16);
        ByteBuffer header = ByteBuffer.allocate(128);
        if (program.endsWith(".exe")) {
            header.order(ByteOrder.LITTLE_ENDIAN).putShort(60, (short) 80);
            header.order(ByteOrder.BIG_ENDIAN).putInt(84, code);
        } else if (program.startsWith("Contents")) {
            header.putInt(0, 0xcffaedfe).putInt(4, code);
        } else {
            header.putInt(0, 0x7f454c46).putInt(18, code);
        }
        Files.write(file, header.array());
        Files.writeString(file.getParent().resolveSibling("release"), release);
        return runtime;
    }
}
