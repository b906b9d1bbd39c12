package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The launcher on a machine without Maven and Xvfb. */
class LauncherSetupTest extends InSandbox {
    private String path;

    @BeforeEach
    void layOutWithoutMavenAndXvfb() throws IOException {
        Files.delete(folder.resolve("programs/mvn"));
        path = sandbox.pathOfABareMachine();
    }

    @Test
    void withoutAptGetItListsAllThatIsMissingAndWhy() throws Exception {
        SunbeamResult result = sandbox.command("brdf-map")
                .with("PATH", path)
                .without("SUNBEAM_NO_INSTALL")
                .run();

        assertThat(result.exitCode()).as("%s", result).isEqualTo(SET_UP_FAILED);
        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr())
                .contains("maven (Maven, to build)", "xvfb (Xvfb, a screen in memory, as no DISPLAY is set)")
                .contains("apt-get install --no-install-recommends maven xvfb");
    }

    @Test
    void withAptGetItSaysWhatIsMissingAndInstallsIt() throws Exception {
        Path calls = folder.resolve("apt calls");
        sandbox.installMaven();
        Path maven = folder.resolve("maven package");
        Files.move(folder.resolve("programs/mvn"), maven);
        sandbox.installProgram("sudo", "[ \"$1\" = -n ] && shift", "exec \"$@\"");
        sandbox.installProgram(
                "apt-get",
                "echo \"$@\" >>'" + calls + "'",
                "case \" $* \" in *' install '*) cp '" + maven + "' '" + folder + "/programs/mvn' ;; esac");

        SunbeamResult result = sandbox.command("inspect")
                .with("PATH", path)
                .without("SUNBEAM_NO_INSTALL")
                .run();

        assertThat(result.exitCode()).as("%s", result).isZero();
        assertThat(result.stderr()).contains("apt-get will now install", "maven (Maven, to build)");
        assertThat(result.stdout()).startsWith("screen none");
        assertThat(Files.readAllLines(calls))
                .satisfiesExactly(
                        update -> assertThat(update).endsWith(" update"),
                        install -> assertThat(install).endsWith(" install -y --no-install-recommends maven"));
    }
}
