package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.NullSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.UsageException;

final class EndingTest {
    @ParameterizedTest
    @CsvSource({
        "PNG, map.jpg, a PNG picture, end it with .png",
        "PNG, .png.gif, a PNG picture, end it with .png",
        "PNG, scan.v1.2, a PNG picture, end it with .png",
        "MESH, a.gltf, a mesh, end it with .obj or .ply or .glb",
        "HDF5, folder.h5/q, an HDF5 file, call it q.h5",
    })
    void aNameThatSaysOtherwiseIsRefusedWithTheOnesThatWillDo(Ending ending, String name, String what, String remedy) {
        assertThatThrownBy(() -> ending.require("--output", Path.of(name)))
                .isInstanceOf(UsageException.class)
                .hasMessage("--output " + name + " would be " + what + ", which its name does not say; " + remedy);
    }

    @ParameterizedTest
    @ValueSource(strings = {"map.png", "map.PNG", "scan.v1.2.png", "folder.jpg/map.png"})
    void aNameThatEndsInPngIsAcceptedForAPngAlone(String name) {
        Ending.PNG.require("--output", Path.of(name));
        assertThatThrownBy(() -> Ending.NPZ.require("--output", Path.of(name))).isInstanceOf(UsageException.class);
    }

    @ParameterizedTest
    @NullSource
    @ValueSource(strings = {"-", "/dev/null", "/", "."})
    void standardOutputDevicesAndFoldersNeedNoEnding(String name) {
        Path named = name == null ? null : Path.of(name);
        assertThat(Ending.values()).allSatisfy(ending -> ending.require("--output", named));
    }
}
