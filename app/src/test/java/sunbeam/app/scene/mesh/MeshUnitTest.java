package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.files.input.InputException;
import sunbeam.app.scene.mesh.format.MeshUnit;
import sunbeam.precompute.text.Text;

/** Units of a mesh's numbers. */
class MeshUnitTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        // Size in the file, unit, words of the warning.
        "1.3,   M,  ",
        "1300,  M,  is 1300 m wide where 100 um to 10 m make sense; if its numbers are in mm give --mesh-unit mm",
        "1300,  MM, ",
        "1.3e6, M,  give --mesh-unit um",
        "1.3e6, UM, ",
        "1.3e-6, M, is 1.3 um wide where 100 um to 10 m make sense; scale it",
        "20,    UM, if its numbers are in mm give --mesh-unit mm",
    })
    void aSizeThatMakesNoSenseIsNamedWithTheUnitThatHelps(double size, MeshUnit unit, String words) throws IOException {
        Path file = Files.writeString(
                folder.resolve("mesh.obj"),
                Text.format("v 0 0 0\nv 0 0 %1$s\nv 0 %2$s 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 1 0 0\n", size, size / 2)
                        + "f 1/1/1 3/3/1 2/2/1\n");

        ReadMesh read = MeshReader.read(file, unit);

        // Rounded to float32.
        assertThat(largest(read.mesh())).isCloseTo((float) (size * unit.meters()), withinPercentage(1e-4));
        if (words == null) {
            assertThat(read.warnings()).isEmpty();
        } else {
            assertThat(read.warnings())
                    .singleElement()
                    .satisfies(line -> assertThat(line.replace(",", "")).contains(words));
        }
    }

    private static float largest(Mesh mesh) {
        float largest = 0;
        for (float value : mesh.positions()) {
            largest = Math.max(largest, value);
        }
        return largest;
    }

    @Test
    void builtInMeshesHaveTheirOwnUnit() {
        assertThatThrownBy(() -> ReadMesh.load(new MeshSource("snake", MeshUnit.CM)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("snake is in meters");
    }
}
