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

/** The launcher's build, what it installs for it, and its failures. */
class LauncherBuildTest extends InSandbox {
    @Test
    void buildsAtTheFirstStartOnlyAndSaysSo() throws Exception {
        SunbeamResult first = command("inspect").run();
        SunbeamResult second = command("inspect").run();

        assertThat(first.stderr()).startsWith("sunbeam: building").hasLineCount(1);
        assertThat(second.stderr()).isEmpty();
        assertThat(builds()).isEqualTo(1);
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
            Files.writeString(repository().resolve(source), "changed");
            command("inspect").run();
            builds++;
            assertThat(builds()).as(source).isEqualTo(builds);
        }
        command("inspect").run();
        assertThat(builds()).as("without a change").isEqualTo(builds);
    }

    @Test
    void aBuildLeavesRunningProgramsTheirLibraries() throws Exception {
        Path signal = folder.resolve("end now");
        installJava("jdk", "17.0.1", "until [ -e '" + signal + "' ]; do sleep 0.05; done");
        try (RunningSunbeam early = command("inspect").start()) {
            early.firstLine();
            installJava("jdk", "17.0.1");

            assertThat(copies()).hasSize(1);
            Path ofEarly = copies().get(0);
            rebuild();

            assertThat(ofEarly.resolve("app-0.1.0.jar")).exists();
            assertThat(ofEarly.resolve("lib")).isDirectory();
            assertThat(copies()).hasSize(2);
            Files.createFile(signal);
            SunbeamResult result = early.end(Duration.ofMinutes(1)).ended(0);
            assertThat(result.stdout())
                    .contains("\n" + ofEarly.toRealPath() + "/*:" + ofEarly.toRealPath() + "/lib/*\n");
        }
        rebuild();
        rebuild();
        assertThat(copies()).as("the three newest").hasSize(3);
    }

    private void rebuild() throws Exception {
        int before = builds();
        Files.writeString(repository().resolve("pom.xml"), "change " + before);
        assertThat(command("inspect").run().exitCode()).isZero();
        assertThat(builds()).isEqualTo(before + 1);
    }

    /** Returns the copies of the build that programs run from. */
    private List<Path> copies() throws IOException {
        try (Stream<Path> files = Files.list(repository().resolve("app/target/run"))) {
            return files.filter(Files::isDirectory).toList();
        }
    }

    @Test
    void twoStartsAtOnceBuildOnce() throws Exception {
        installMaven("sleep 1");

        try (RunningSunbeam one = command("inspect").start();
                RunningSunbeam other = command("inspect").start()) {
            assertThat(one.end(Duration.ofMinutes(1)).exitCode()).isZero();
            assertThat(other.end(Duration.ofMinutes(1)).exitCode()).isZero();
        }

        assertThat(builds()).isEqualTo(1);
    }

    @Test
    void aFailedBuildIsOneLineWithItsReasonAndTheLog() throws Exception {
        installProgram("mvn", "echo '[INFO] so far'", "echo '[ERROR] App.java:[3,1] no such color'", "exit 1");

        SunbeamResult result = command("inspect").run();

        Path log = repository().toRealPath().resolve("app/target/launcher-build.log");
        result.ended(SET_UP_FAILED);
        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr().lines().skip(1))
                .containsExactly("sunbeam: the build failed: App.java:[3,1] no such color; Maven's own words: " + log);
        assertThat(log).content().contains("[INFO] so far");
    }

    /** Javac's message about -Werror names no place, but the warning does. */
    @Test
    void aBuildThatFailsOnAWarningTellsTheWarning() throws Exception {
        installProgram(
                "mvn",
                "case \"$*\" in *' -q '*) ;; *) echo '[WARNING] /a/App.java:[7,5] unused' ;; esac",
                "echo '[ERROR] warnings found and -Werror specified'",
                "exit 1");

        assertThat(command("inspect").run().stderr())
                .contains("the build failed: /a/App.java:[7,5] unused; Maven's own words");
    }

    @ParameterizedTest
    @ValueSource(strings = {"archive", "test"})
    void helpOfTheLaunchersOwnCommandsBuildsNothing(String command) throws Exception {
        SunbeamResult result = command(command, "--help").run().ended(0);
        assertThat(result.stdout()).contains("./sunbeam " + command);
        assertThat(builds()).isZero();
    }

    private SunbeamResult runWithoutMavenAndXvfb(String command) throws Exception {
        Files.deleteIfExists(folder.resolve("programs/mvn"));
        return command(command)
                .with("PATH", pathOfABareMachine())
                .without("SUNBEAM_NO_INSTALL")
                .run();
    }

    @Test
    void withoutAptGetItListsAllThatIsMissingAndWhy() throws Exception {
        SunbeamResult result = runWithoutMavenAndXvfb("brdf-map").ended(SET_UP_FAILED);
        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr())
                .contains("maven (Maven, to build)", "xvfb (Xvfb, a screen in memory, as no DISPLAY is set)")
                .contains("apt-get install --no-install-recommends maven xvfb");
    }

    @Test
    void withAptGetItSaysWhatIsMissingAndInstallsIt() throws Exception {
        Path calls = folder.resolve("apt calls");
        Path maven = folder.resolve("maven package");
        Files.move(folder.resolve("programs/mvn"), maven);
        installProgram("sudo", "[ \"$1\" = -n ] && shift", "exec \"$@\"");
        installProgram(
                "apt-get",
                "echo \"$@\" >>'" + calls + "'",
                "case \" $* \" in *' install '*) cp '" + maven + "' '" + folder + "/programs/mvn' ;; esac");

        SunbeamResult result = runWithoutMavenAndXvfb("inspect").ended(0);
        assertThat(result.stderr()).contains("apt-get will now install", "maven (Maven, to build)");
        assertThat(result.stdout()).startsWith("screen none");
        assertThat(Files.readAllLines(calls))
                .satisfiesExactly(
                        update -> assertThat(update).endsWith(" update"),
                        install -> assertThat(install).endsWith(" install -y --no-install-recommends maven"));
    }
}
