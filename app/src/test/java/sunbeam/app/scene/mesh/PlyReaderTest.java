package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Properties of PLY alone. */
class PlyReaderTest extends MeshReading {
    /** A strip of two triangles, an end, one of one triangle, an end. All face upwards. */
    @Test
    void stripsAreTriangles() throws IOException {
        String header = """
                ply
                format ascii 1.0
                element vertex 5
                property float x
                property float y
                property float z
                element tristrips 1
                property list int int vertex_indices
                end_header
                0 0 0  1 0 0  0 1 0  1 1 0  2 2 0
                """;
        Mesh mesh = read(header + "9 0 1 2 3 -1 1 4 2 -1\n").mesh();
        assertThat(mesh.triangles()).isEqualTo(3);
        for (int triangle = 0; triangle < 3; triangle++) {
            assertThat(MeshChecks.areaNormal(mesh, triangle).z).isPositive();
        }
        assertRefused(header + "4 0 1 2 5\n").hasMessageContaining("tristrips 0: it names vertex 5");
        assertRefused(header + "4 0 1 2 -2\n").hasMessageContaining("tristrips 0: it names vertex -2");
        assertRefused(header + "7000000 0 1 2\n").hasMessageContaining("0 to 6000000 can be used");
        assertRefused(header.replace("vertex_indices", "strips") + "3 0 1 2\n")
                .hasMessageContaining("no list vertex_indices");
        assertRefused(header + "2 0 1\n").hasMessageContaining("no faces");
    }

    @Test
    void invalidPlyIsRefusedInOneLine() {
        String header = """
                ply
                format ascii 1.0
                element vertex 3
                property float x
                property float y
                property float z
                element face 1
                property list uchar int vertex_indices
                end_header
                """;
        String places = "0 0 0\n1 0 0\n0 1 0\n";
        assertRefused(header + places + "3 0 1 3\n").hasMessageContaining("face 0: it names vertex 3");
        assertRefused(header + places + "2 0 1\n").hasMessageContaining("2 corners");
        assertRefused(header + places + "3 0 1 0.5\n").hasMessageContaining("vertex 0.5");
        assertRefused(header + places).hasMessageContaining("face 0: the file ends within it");
        assertRefused(header + "0 0 0\n1 nan 0\n").hasMessageContaining("vertex 1: \"nan\" is no number");
        assertRefused(header + "0 0 0\n1 NaN 0\n").hasMessageContaining("vertex 1: NaN is no finite number");
        assertRefused(header.replace("face 1", "face 10000000") + places)
                .hasMessageContaining("10000000 rows of element face; at most 2000000");
        assertRefused(header.replace("float z", "float w") + places).hasMessageContaining("not x, y and z");
        assertRefused(header.replace("float z", "real z") + places).hasMessageContaining("line 6");
        assertRefused(header.replace("vertex_indices", "corners") + places)
                .hasMessageContaining("no list vertex_indices");
        assertRefused("ply\nformat ascii 1.0\nend_header\n").hasMessageContaining("no face");
        assertRefused("ply\n").hasMessageContaining("line 2 of the header");
    }

    @Test
    void cornersOfPlyHaveTextureCoordinatesOfTheirOwn() throws IOException {
        String text = """
                ply
                format ascii 1.0
                element vertex 4
                property float x
                property float y
                property float z
                element face 1
                property list uchar int vertex_index
                property list uchar float texcoord
                end_header
                0 0 0
                1 0 0
                1 1 0
                0 1 0
                4 0 1 2 3 8 0 0 0 1 -1 1 -1 0
                """;

        Mesh mesh = read(text).mesh();

        // u grows against y.
        assertThat(mesh.triangles()).isEqualTo(2);
        assertThat(mesh.tangents()).startsWith(0, -1, 0, 1);
    }
}
