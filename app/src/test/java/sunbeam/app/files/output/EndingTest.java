package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.assertj.core.api.AbstractThrowableAssert;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.UsageException;

/** A PNG needs a name that ends in .png. */
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
    @ValueSource(strings = {"map.png", "map.PNG", "scan.v1.2.png", "folder.jpg/map.png"})
    void aNameThatEndsInPngIsAcceptedForAPngAlone(String name) {
        for (Ending ending : Ending.values()) {
            AbstractThrowableAssert<?, ?> failure = assertThatCode(() -> ending.require("--output", Path.of(name)))
                    .as("%s", ending);
            if (ending == Ending.PNG) {
                failure.doesNotThrowAnyException();
            } else {
                failure.isInstanceOf(UsageException.class);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"-", "/dev/null", "/", "."})
    void standardOutputDevicesAndFoldersNeedNoEnding(String name) {
        assertThat(Ending.values()).allSatisfy(ending -> ending.require("--output", Path.of(name)));
    }

    @Test
    void anOptionThatIsNotGivenIsAccepted() {
        assertThat(Ending.values()).allSatisfy(ending -> ending.require("--output", null));
    }
}
