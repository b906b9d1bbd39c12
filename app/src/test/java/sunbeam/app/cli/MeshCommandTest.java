package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.terminal.ExitCode;

class MeshCommandTest extends CommandLineFixture {
    private MeshSource.Loaded load(String name) {
        return MeshSource.of(folder.resolve(name).toString()).load();
    }

    @Test
    void everyBuiltInMeshIsWritten() {
        for (String name : BuiltInMeshes.names()) {
            assertSuccess(sunbeam("mesh " + name + " --output @" + name + ".obj"));
            assertThat(load(name + ".obj").mesh().triangles())
                    .isEqualTo(BuiltInMeshes.create(name).triangles());
        }
        assertThat(err.toString()).isEmpty();
        assertThat(out.toString()).containsPattern("snake\\.obj: \\d+ vertices, \\d+ triangles");
    }

    @Test
    void anObjFileIsCheckedAndCompleted() throws IOException {
        Files.writeString(folder.resolve("in.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 1 2\n");
        assertSuccess(sunbeam("mesh @in.obj --output @out.obj"));
        assertThat(err.toString().lines())
                .hasSize(3)
                .allMatch(line -> line.startsWith("sunbeam: warning: ") && line.contains("in.obj"));
        assertThat(out.toString()).as("in the singular").contains("out.obj: 3 vertices, 1 triangle\n");
        assertThat(load("out.obj").warnings()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"obj", "ply", "glb"})
    void theFilesNameChoosesTheFormat(String ending) {
        assertSuccess(sunbeam("mesh plane --output @plane." + ending));
        assertThat(load("plane." + ending).mesh().triangles())
                .isEqualTo(BuiltInMeshes.create("plane").triangles());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            plane --output a.stl                      | USAGE          | a.stl
            snake --texture dark --output @worn.obj   | USAGE          | --texture dark needs a format with pictures
            plane --scales keeled --output @worn.glb  | USAGE          | --scales keeled is for mesh snake
            plane --mesh-unit mm --output @worn.glb   | UNUSABLE_INPUT | in meters
            """)
    void whatAFormatOrAMeshDoesNotHaveIsRefused(String words, ExitCode code, String reason) {
        assertComplaint(code, "mesh " + words, reason);
    }
}
