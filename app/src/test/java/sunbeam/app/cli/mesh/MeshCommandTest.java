package sunbeam.app.cli.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.app.cli.CommandLineFixture;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.terminal.ExitCode;

class MeshCommandTest extends CommandLineFixture {
    @Test
    void everyBuiltInMeshIsWritten() {
        for (String name : BuiltInMeshes.names()) {
            Path file = folder.resolve(name + ".obj");

            assertThat(sunbeam("mesh", name, "--output", file.toString())).isZero();

            assertThat(MeshSource.of(file.toString()).load().mesh().triangles())
                    .isEqualTo(BuiltInMeshes.create(name).triangles());
        }
        assertThat(err.toString()).isEmpty();
        assertThat(out.toString()).containsPattern("snake\\.obj: \\d+ vertices, \\d+ triangles");
    }

    @Test
    void aFileIsNotOverwrittenWithoutForce() throws IOException {
        Path file = Files.writeString(folder.resolve("x.obj"), "mine");

        assertThat(sunbeam("mesh", "plane", "--output", file.toString())).isEqualTo(ExitCode.OUTPUT_EXISTS.code());
        assertThat(file).hasContent("mine");
        assertThat(sunbeam("mesh", "plane", "--output", file.toString(), "--force"))
                .isZero();
        assertThat(MeshSource.of(file.toString()).load().mesh().triangles()).isPositive();
    }

    @Test
    void anObjFileIsCheckedAndCompleted() throws IOException {
        Path in =
                Files.writeString(folder.resolve("in.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 1 2\n");
        Path file = folder.resolve("out.obj");

        assertThat(sunbeam("mesh", in.toString(), "--output", file.toString())).isZero();

        assertThat(err.toString().lines())
                .hasSize(3)
                .allMatch(line -> line.startsWith("sunbeam: warning: ") && line.contains("in.obj"));
        assertThat(MeshSource.of(file.toString()).load().warnings()).isEmpty();
    }

    @Test
    void indicesThatPointNowhereAreNamedAsTheFileHasThem() throws IOException {
        String positions = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        Path forwards = Files.writeString(folder.resolve("forwards.obj"), positions + "f 1 2 9\n");
        Path backwards = Files.writeString(folder.resolve("backwards.obj"), positions + "f -1 -2 -9\n");
        String output = folder.resolve("out.obj").toString();

        assertThat(sunbeam("mesh", forwards.toString(), "--output", output)).isEqualTo(ExitCode.UNUSABLE_INPUT.code());
        assertThat(sunbeam("mesh", backwards.toString(), "--output", output)).isEqualTo(ExitCode.UNUSABLE_INPUT.code());
        assertThat(err.toString()).contains("line 4: the face names position 9 but 3", "position -9 but 3");
    }

    @Test
    void oneTriangleIsCountedInTheSingular() throws IOException {
        Path in = Files.writeString(folder.resolve("in.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");

        sunbeam("mesh", in.toString(), "--output", folder.resolve("out.obj").toString());

        assertThat(out.toString()).contains("out.obj: 3 vertices, 1 triangle\n");
    }

    @Test
    void theFilesNameChoosesTheFormat() {
        for (String ending : List.of("obj", "ply", "glb")) {
            Path file = folder.resolve("plane." + ending);

            assertThat(sunbeam("mesh", "plane", "--output", file.toString())).isZero();

            assertThat(MeshSource.of(file.toString()).load().mesh().triangles())
                    .isEqualTo(BuiltInMeshes.create("plane").triangles());
        }
        String obj = folder.resolve("worn.obj").toString();
        String glb = folder.resolve("worn.glb").toString();
        assertThat(sunbeam("mesh", "plane", "--output", "a.stl")).isEqualTo(ExitCode.USAGE.code());
        assertThat(sunbeam("mesh", "snake", "--texture", "dark", "--output", obj))
                .isEqualTo(ExitCode.USAGE.code());
        assertThat(sunbeam("mesh", "plane", "--scales", "keeled", "--output", glb))
                .isEqualTo(ExitCode.USAGE.code());
        assertThat(sunbeam("mesh", "plane", "--mesh-unit", "mm", "--output", glb))
                .isEqualTo(ExitCode.UNUSABLE_INPUT.code());
        assertThat(err.toString().lines().toList()).hasSize(4);
        assertThat(err.toString())
                .contains(
                        "--texture dark needs a format with pictures",
                        "--scales keeled is for mesh snake",
                        "in meters");
    }
}
