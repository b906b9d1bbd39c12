package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.UsageException;

/** A name that says JPEG, EXR, table or nothing is not given to a PNG. */
final class EndingTest {
    @ParameterizedTest
    @ValueSource(strings = {"map.jpg", "map.JPEG", "folder/map.exr", "map.npy", "map.csv", ".png.gif", "scan.v1.2"})
    void aNameThatSaysOtherwiseIsRefused(String name) {
        assertThatThrownBy(() -> Ending.PNG.require("--output", Path.of(name)))
                .isInstanceOf(UsageException.class)
                .hasMessage(
                        "--output " + name + " would be a PNG picture, which its name does not say; end it with .png");
    }

    @Test
    void allEndingsThatWillDoAreNamed() {
        assertThatThrownBy(() -> Ending.MESH.require("--output", Path.of("a.gltf")))
                .hasMessage(
                        "--output a.gltf would be a mesh, which its name does not say; end it with .obj or .ply or .glb");
    }

    @Test
    void aNameWithoutEndingIsRefusedWithTheNameThatWillDo() {
        assertThatThrownBy(() -> Ending.HDF5.require("--output", Path.of("folder.h5/q")))
                .hasMessage("--output folder.h5/q would be an HDF5 file, which its name does not say; call it q.h5");
    }

    @ParameterizedTest
    @ValueSource(strings = {"map.png", "map.PNG", "scan.v1.2.png", "folder.jpg/map.png", "-", "/dev/null", "/", "."})
    void othersPass(String name) {
        assertThatCode(() -> Ending.PNG.require("--output", Path.of(name))).doesNotThrowAnyException();
    }

    @Test
    void aNameOfSunbeamsChoicePasses() {
        assertThatCode(() -> Ending.PNG.require("--output", null)).doesNotThrowAnyException();
    }
}
