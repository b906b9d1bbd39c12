package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Machines that cannot draw. (Neither a display nor Xvfb: {@link LauncherScreenTest}; shaders: {@link
 * BrokenShaderTest}.) */
class NoGraphicsTest {
    @TempDir
    Path root;

    private Workplace workplace;

    @BeforeEach
    void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    @Test
    void aDisplayThatDoesNotAnswer() throws Exception {
        Complaint.assertThatIt(
                brdfMap().with("DISPLAY", "localhost:9876").run(),
                Complaint.NO_GRAPHICS,
                "no display: DISPLAY=localhost:9876 does not answer. Set DISPLAY to a running X server");
        assertThat(workplace.files()).isEmpty();
    }

    /** An X server without the extension that OpenGL goes through. */
    @Test
    void aDisplayWithoutOpenGl() throws Exception {
        Path launcher = launcherWith(Xvfb.WITHOUT_OPENGL);

        SunbeamResult result = workplace
                .equip(Sunbeam.launcher(launcher, "brdf-map", "--patch", "blaze", "--size", "8"))
                .without("DISPLAY")
                .run();

        Complaint.assertThatIt(
                result, Complaint.NO_GRAPHICS, "no OpenGL 3.3 core context on display :", "Install a driver");
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void theDoctorSaysWhatToDoAndFails() throws Exception {
        SunbeamResult result =
                workplace.command("doctor").with("DISPLAY", "localhost:9876").run();

        assertThat(result.exitCode()).as("%s", result).isEqualTo(Complaint.NO_GRAPHICS);
        assertThat(result.stdout())
                .contains("ok    Java", "FAIL  Graphics", "DISPLAY=localhost:9876 does not answer. Set");
    }

    @Test
    void whatNeedsNoGraphicsWorksWithoutThem() throws Exception {
        SunbeamResult result = workplace
                .command("precompute", "--patch", "blaze", "--output", "blaze.h5")
                .with("DISPLAY", ":9876")
                .run();

        assertThat(result.exitCode()).as("%s", result).isZero();
        assertThat(workplace.files()).containsExactly("blaze.h5");
    }

    private Sunbeam brdfMap() {
        return workplace.command("brdf-map", "--patch", "blaze", "--size", "8");
    }

    /** How the launcher's private screen is started. */
    private enum Xvfb {
        USUAL,
        WITHOUT_OPENGL
    }

    /** The real launcher, after some shell commands and with a screen of some kind. */
    private Path launcherWith(Xvfb screen, String... shellCommands) throws IOException {
        Path programs = Files.createDirectory(root.resolve("programs"));
        if (screen == Xvfb.WITHOUT_OPENGL) {
            script(programs.resolve("Xvfb"), "PATH=${PATH#*:}", "exec Xvfb -extension GLX \"$@\"");
        }
        Path launcher = root.resolve("launcher");
        String start = "exec '" + Sunbeam.repository().resolve("sunbeam") + "' \"$@\"";
        script(
                launcher,
                Stream.concat(
                                Stream.of("PATH='" + programs + "':$PATH", "export PATH"),
                                Stream.concat(Stream.of(shellCommands), Stream.of(start)))
                        .toArray(String[]::new));
        return launcher;
    }

    private static void script(Path file, String... lines) throws IOException {
        Files.writeString(file, "#!/bin/sh\n" + String.join("\n", lines) + "\n");
        assertThat(file.toFile().setExecutable(true)).isTrue();
    }
}
