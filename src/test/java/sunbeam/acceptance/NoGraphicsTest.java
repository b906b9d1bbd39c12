package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Machines without OpenGL. (Neither a display nor Xvfb: {@link LauncherScreenTest}; shaders: {@link BrokenShaderTest}.) */
class NoGraphicsTest extends InWorkplace {
    @Test
    void aDisplayThatDoesNotAnswer() throws Exception {
        Complaint.assertThatIt(
                brdfMap().with("DISPLAY", "localhost:9876").run(),
                Complaint.NO_GRAPHICS,
                "no display: DISPLAY=localhost:9876 does not answer. Set DISPLAY to a running X server");
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
                .command("precompute --patch blaze --output blaze.h5")
                .with("DISPLAY", ":9876")
                .run();

        assertThat(result.exitCode()).as("%s", result).isZero();
        assertThat(workplace.files()).containsExactly("blaze.h5");
    }

    private Sunbeam brdfMap() {
        return workplace.command("brdf-map --patch blaze --size 8");
    }
}
