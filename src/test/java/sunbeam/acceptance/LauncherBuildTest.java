package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The launcher's build and its failures. */
class LauncherBuildTest extends InSandbox {
    @Test
    void buildsAtTheFirstStartOnlyAndSaysSo() throws Exception {
        SunbeamResult first = sandbox.command("inspect").run();
        SunbeamResult second = sandbox.command("inspect").run();

        assertThat(first.stderr()).startsWith("sunbeam: building").hasLineCount(1);
        assertThat(second.stderr()).isEmpty();
        assertThat(sandbox.builds()).isEqualTo(1);
    }

    @Test
    void buildsAgainAfterAChangeOfWhatTheBuildReads() throws Exception {
        int builds = 0;
        for (String source : List.of(
                "pom.xml",
                "app/pom.xml",
                "precompute/src/main/java/Precompute.java",
                "jrtr/src/main/java/New.java",
                "shaders/full.frag",
                "data/color.csv")) {
            Files.writeString(sandbox.repository().resolve(source), "changed");
            sandbox.command("inspect").run();
            builds++;
            assertThat(sandbox.builds()).as(source).isEqualTo(builds);
        }
        sandbox.command("inspect").run();
        assertThat(sandbox.builds()).as("without a change").isEqualTo(builds);
    }

    @Test
    void aBuildLeavesRunningProgramsTheirLibraries() throws Exception {
        Path signal = folder.resolve("end now");
        sandbox.installJava("jdk", "17.0.1", "until [ -e '" + signal + "' ]; do sleep 0.05; done");
        try (RunningSunbeam early = sandbox.command("inspect").start()) {
            early.firstLine(Duration.ofMinutes(1));
            sandbox.installJava("jdk", "17.0.1");

            Path ofEarly = onlyCopy();
            rebuild();

            assertThat(ofEarly.resolve("app-0.1.0.jar")).exists();
            assertThat(ofEarly.resolve("lib")).isDirectory();
            assertThat(copies()).hasSize(2);
            Files.createFile(signal);
            SunbeamResult result = early.end(Duration.ofMinutes(1));
            assertThat(result.exitCode()).as("%s", result).isZero();
            assertThat(result.stdout())
                    .contains("\n" + ofEarly.toRealPath() + "/*:" + ofEarly.toRealPath() + "/lib/*\n");
        }
        // No program runs from the first copy any more, nor from the second once there is a third.
        rebuild();
        assertThat(copies()).hasSize(1);
    }

    private void rebuild() throws Exception {
        int before = sandbox.builds();
        Files.writeString(sandbox.repository().resolve("pom.xml"), "change " + before);
        assertThat(sandbox.command("inspect").run().exitCode()).isZero();
        assertThat(sandbox.builds()).isEqualTo(before + 1);
    }

    private Path onlyCopy() throws IOException {
        assertThat(copies()).hasSize(1);
        return copies().get(0);
    }

    /** Returns the copies of the build that programs run from. */
    private List<Path> copies() throws IOException {
        try (Stream<Path> files = Files.list(sandbox.repository().resolve("app/target/run"))) {
            return files.filter(Files::isDirectory).toList();
        }
    }

    @Test
    void twoStartsAtOnceBuildOnce() throws Exception {
        sandbox.installMaven("sleep 1");

        try (RunningSunbeam one = sandbox.command("inspect").start();
                RunningSunbeam other = sandbox.command("inspect").start()) {
            assertThat(one.end(Duration.ofMinutes(1)).exitCode()).isZero();
            assertThat(other.end(Duration.ofMinutes(1)).exitCode()).isZero();
        }

        assertThat(sandbox.builds()).isEqualTo(1);
    }

    @Test
    void aFailedBuildIsOneLineWithItsReasonAndTheLog() throws Exception {
        sandbox.installProgram("mvn", "echo '[INFO] so far'", "echo '[ERROR] App.java:[3,1] no such color'", "exit 1");

        SunbeamResult result = sandbox.command("inspect").run();

        Path log = sandbox.repository().toRealPath().resolve("app/target/launcher-build.log");
        assertThat(result.exitCode()).isEqualTo(SET_UP_FAILED);
        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr().lines().skip(1))
                .containsExactly("sunbeam: the build failed: App.java:[3,1] no such color; Maven's own words: " + log);
        assertThat(log).content().contains("[INFO] so far");
    }

    /** Javac's message about -Werror names no place, but the warning does. */
    @Test
    void aBuildThatFailsOnAWarningTellsTheWarning() throws Exception {
        sandbox.installProgram(
                "mvn",
                "case \"$*\" in *' -q '*) ;; *) echo '[WARNING] /a/App.java:[7,5] unused' ;; esac",
                "echo '[ERROR] warnings found and -Werror specified'",
                "exit 1");

        assertThat(sandbox.command("inspect").run().stderr())
                .contains("the build failed: /a/App.java:[7,5] unused; Maven's own words");
    }

    @ParameterizedTest
    @ValueSource(strings = {"archive", "test"})
    void helpOfTheLaunchersOwnCommandsBuildsNothing(String command) throws Exception {
        SunbeamResult result = sandbox.command(command, "--help").run();

        assertThat(result.exitCode()).as("%s", result).isZero();
        assertThat(result.stdout()).contains("./sunbeam " + command);
        assertThat(sandbox.builds()).isZero();
    }

    @Test
    void anArchiveIsNamedOnceItIsBuilt() throws Exception {
        sandbox.installMaven("mkdir -p app/target && touch app/target/sunbeam-0.1.0-portable.zip");

        SunbeamResult result = sandbox.command("archive").run();

        assertThat(result.exitCode()).as("%s", result).isZero();
        assertThat(result.stdout().strip()).endsWith("/app/target/sunbeam-0.1.0-portable.zip");
    }

    @Test
    void anArchiveThatFailsNamesTheLog() throws Exception {
        sandbox.installMaven("exit 1");

        SunbeamResult result = sandbox.command("archive").run();

        assertThat(result.exitCode()).isEqualTo(SET_UP_FAILED);
        assertThat(result.stderr()).contains("no archives were built", "launcher-build.log");
        assertThat(result.stdout()).isEmpty();
    }
}
