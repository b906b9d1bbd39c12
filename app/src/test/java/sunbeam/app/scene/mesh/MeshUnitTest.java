package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/** Units of a mesh's numbers, and meshes at coordinates of maps (UTM), thousands of kilometers from the origin. */
class MeshUnitTest extends MeshReading {
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
    void aSizeThatMakesNoSenseIsNamedWithTheUnitThatHelps(double size, MeshSource.Unit unit, String words)
            throws IOException {
        Path file = Files.writeString(
                folder.resolve("mesh.obj"),
                Text.format("v 0 0 0\nv 0 0 %1$s\nv 0 %2$s 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 1 0 0\n", size, size / 2)
                        + "f 1/1/1 3/3/1 2/2/1\n");

        MeshSource.Loaded read = MeshSource.read(file, unit);

        // Rounded to float32.
        assertThat(largest(read.mesh())).isCloseTo((float) (size * unit.meters), withinPercentage(1e-4));
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
        assertThatThrownBy(() -> new MeshSource("snake", MeshSource.Unit.CM).load())
                .isInstanceOf(InputException.class)
                .hasMessageContaining("snake is in meters");
    }

    private static String obj(Mesh mesh, Vector3d shift) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < mesh.vertices(); i++) {
            Vector3d p = MeshChecks.position(mesh, i).add(shift);
            text.append(Text.format("v %.9f %.9f %.9f%n", p.x, p.y, p.z));
        }
        for (int i = 0; i < mesh.indices().length; i++) {
            text.append(i % 3 == 0 ? "\nf " : " ").append(mesh.indices()[i] + 1);
        }
        return text.toString();
    }

    @Test
    void shapesSurviveFarFromTheOrigin() throws IOException {
        Mesh sphere = BuiltInMeshes.create("sphere");
        Vector3d utm = new Vector3d(500_000, 5_400_000, 300);
        MeshSource.Loaded far = read(obj(sphere, utm));
        assertThat(far.mesh().triangles()).isEqualTo(sphere.triangles());
        // Doubles have steps of 1e-9 m there, 1e-8 of the radius; edges of a hundredth of it.
        assertThat(MeshChecks.area(far.mesh())).isCloseTo(MeshChecks.area(sphere), withinPercentage(1e-3));
        assertThat(far.warnings())
                .noneMatch(warning -> warning.contains("dropped"))
                .anyMatch(warning -> warning.contains("center (500000.000, 5400000.000, 300.000) m is moved"));
        assertThat(MeshChecks.position(far.mesh(), 0).length()).isLessThan(0.11);
        MeshSource.Loaded near = read(obj(sphere, new Vector3d(50, 0, 0)));
        assertThat(near.warnings()).noneMatch(warning -> warning.contains("moved"));
        assertThat(MeshChecks.position(near.mesh(), 0).x).isCloseTo(50, within(0.11));
    }
}
