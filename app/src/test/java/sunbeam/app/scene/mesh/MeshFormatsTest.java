package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** PLY and glTF beside OBJ. */
class MeshFormatsTest extends MeshReading {
    private static final Mesh SURFACE = BuiltInMeshes.cylinder(0.1, 0.2, 12, 3);

    @Test
    void theSameSurfaceIsReadFromEveryFormat() throws IOException {
        ByteArrayOutputStream obj = new ByteArrayOutputStream();
        MeshWriters.obj(obj, SURFACE);
        Mesh expected = read(obj.toByteArray()).mesh();
        byte[] buffer = MeshFiles.buffer(SURFACE);
        Files.write(folder.resolve("a b.bin"), buffer);

        for (String encoding : List.of("ascii", "binary_little_endian", "binary_big_endian")) {
            MeshSource.Loaded ply = read(MeshFiles.ply(SURFACE, encoding));
            assertThat(ply.warnings()).isEmpty();
            assertSame(ply.mesh(), expected);
            // The file's numbers are floats; those of OBJ have more digits.
            assertThat(ply.mesh().tangents())
                    .as("from the same texture")
                    .containsExactly(expected.tangents(), within(1e-6f));
        }
        for (MeshSource.Loaded gltf : List.of(
                read(MeshFiles.glb(SURFACE)),
                read(MeshFiles.gltf(SURFACE, "a%20b.bin")),
                read(MeshFiles.gltf(SURFACE, MeshFiles.dataUri(buffer))))) {
            assertThat(gltf.warnings()).isEmpty();
            assertSame(gltf.mesh(), expected);
        }
    }

    private static void assertSame(Mesh mesh, Mesh expected) {
        assertThat(mesh.triangles()).isEqualTo(expected.triangles());
        for (int i = 0; i < mesh.indices().length; i++) {
            int vertex = mesh.indices()[i];
            int other = expected.indices()[i];
            assertThat(MeshChecks.position(mesh, vertex)).isEqualTo(MeshChecks.position(expected, other));
            // Normalized again; 1 - (1 - v) rounded.
            assertThat(MeshChecks.normal(mesh, vertex).distance(MeshChecks.normal(expected, other)))
                    .isLessThan(MeshChecks.ROUNDING);
            for (int axis = 0; axis < 2; axis++) {
                assertThat(mesh.textureCoordinates()[2 * vertex + axis])
                        .isCloseTo(expected.textureCoordinates()[2 * other + axis], within(1e-6f));
            }
        }
    }

    @Test
    void tangentsOfTheFileAreTheDirectionsOfThePatch() throws IOException {
        // A quarter turn from the texture's u, one vertex without, and one side left-handed.
        float[] tangents = SURFACE.tangents().clone();
        for (int i = 0; i < SURFACE.vertices(); i++) {
            Vector3d turned = MeshChecks.normal(SURFACE, i).cross(MeshChecks.tangent(SURFACE, i));
            tangents[4 * i] = (float) turned.x;
            tangents[4 * i + 1] = (float) turned.y;
            tangents[4 * i + 2] = (float) turned.z;
            tangents[4 * i + 3] = i % 2 == 0 ? 1 : -1;
        }
        Mesh turned = new Mesh(
                SURFACE.positions(),
                SURFACE.normals(),
                tangents,
                SURFACE.textureCoordinates(),
                SURFACE.indices(),
                false);

        Mesh mesh = read(MeshFiles.glb(turned)).mesh();

        MeshChecks.assertOrthonormalFrames(mesh);
        for (int i = 0; i < mesh.indices().length; i++) {
            int from = turned.indices()[i];
            int to = mesh.indices()[i];
            assertThat(MeshChecks.tangent(mesh, to).distance(MeshChecks.tangent(turned, from)))
                    .isLessThan(MeshChecks.ROUNDING);
            assertThat(mesh.tangents()[4 * to + 3]).isEqualTo(tangents[4 * from + 3]);
        }
    }

    @Test
    void nodesPlaceMeshesAlsoMirrored() throws IOException {
        String json = MeshFiles.gltf(SURFACE).replace("\"nodes\":[{\"mesh\":0}]", """
                        "nodes":[{"children":[1,2],"translation":[0,0,-5]},
                        {"mesh":0,"scale":[2,2,-2]},
                        {"mesh":0,"rotation":[0,0.70710678,0,0.70710678],"translation":[0,3,0]}]
                        """);

        Mesh mesh = read(json).mesh();

        // glTF's (x, y, z) is (x, -z, y): moved by 5 along y; doubled and mirrored in y; turned about z by a quarter
        // and lifted.
        int corners = SURFACE.indices().length;
        assertThat(mesh.indices()).hasSize(2 * corners);
        for (int i = 0; i < corners; i++) {
            Vector3d position = MeshChecks.position(SURFACE, SURFACE.indices()[i]);
            Vector3d turned = MeshChecks.position(mesh, mesh.indices()[corners + i]);
            assertThat(turned.distance(new Vector3d(-position.y, position.x + 5, position.z + 3)))
                    .as("float32 at a distance of 5")
                    .isLessThan(1e-6);
        }
        MeshChecks.assertOrthonormalFrames(mesh);
        // A facet of a twelfth of a turn is half of that away from its corners' normals: cos 15 degrees.
        MeshChecks.assertNormalsFaceOutwards(mesh, 0.96);
        MeshChecks.assertTangentsFollowTheTexture(mesh, 0.96);
        assertThat(mesh.tangents()[3]).as("mirrored").isEqualTo(-1);
    }

    @Test
    void stripsFansAndMissingIndicesAreTriangles() throws IOException {
        // A unit square in glTF's x and y, which faces its z: our -y.
        String square = "0,0,0, 1,0,0, 0,1,0, 1,1,0";
        Mesh strip = read(positions(5, square)).mesh();
        Mesh fan = read(positions(6, "0,0,0, 1,0,0, 1,1,0, 0,1,0")).mesh();
        Mesh triangle = read(positions(4, square)).mesh();
        Mesh hidden = read(positions(5, square)
                        .replace("[{\"mesh\":0}]", "[{\"mesh\":0},{\"mesh\":0,\"scale\":[0,1,1]}]"))
                .mesh();

        for (Mesh mesh : List.of(strip, fan, hidden)) {
            assertThat(mesh.triangles()).isEqualTo(2);
            for (int i = 0; i < 2; i++) {
                assertThat(MeshChecks.areaNormal(mesh, i).distance(new Vector3d(0, -1, 0)))
                        .isLessThan(1e-6);
            }
        }
        assertThat(triangle.triangles()).isEqualTo(1);
        assertThat(triangle.normals()).startsWith(0, -1, 0);
        assertRefused(positions(1, square), "no faces");
    }

    private static String positions(int mode, String numbers) {
        String[] all = numbers.split(",", -1);
        ByteBuffer bytes = ByteBuffer.allocate(4 * all.length).order(ByteOrder.LITTLE_ENDIAN);
        for (String number : all) {
            bytes.putFloat(Float.parseFloat(number.strip()));
        }
        return "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
                + "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":" + mode + "}]}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":" + all.length / 3
                + ",\"type\":\"VEC3\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + 4 * all.length + "}],"
                + "\"buffers\":[{\"uri\":\"" + MeshFiles.dataUri(bytes.array()) + "\",\"byteLength\":" + 4 * all.length
                + "}]}";
    }

    @Test
    void sparseAccessorsReplaceSomeValues() throws IOException {
        byte[] content = {2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 64, 0, 0, 0, 0};
        String json = positions(4, "0,0,0, 1,0,0, 0,1,0")
                .replace(
                        "\"VEC3\"",
                        "\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,\"componentType\":5121},"
                                + "\"values\":{\"bufferView\":1,\"byteOffset\":4}}")
                .replace(
                        "\"byteLength\":36}],\"buffers\":[",
                        "\"byteLength\":36},{\"buffer\":1,\"byteLength\":16}],\"buffers\":[")
                .replace(
                        "\"byteLength\":36}]}",
                        "\"byteLength\":36},{\"uri\":\"" + MeshFiles.dataUri(content) + "\"}]}");

        Mesh mesh = read(json).mesh();

        // Vertex 2 is (0, 3, 0), so that twice the area is 3.
        assertThat(MeshChecks.areaNormal(mesh, 0).length()).isCloseTo(3, within(1e-6));
    }

    @Test
    void buffersLieInTheFolder(@TempDir Path elsewhere) throws IOException {
        Path outside = Files.write(elsewhere.resolve("outside.bin"), MeshFiles.buffer(SURFACE));
        Files.createSymbolicLink(folder.resolve("link.bin"), outside);

        for (String uri : List.of("../outside.bin", "%2e%2e/outside.bin", outside.toString())) {
            assertRefused(MeshFiles.gltf(SURFACE, uri), "leads out of the mesh's own folder");
        }
        assertRefused(MeshFiles.gltf(SURFACE, "link.bin"), "link that leads out");
        assertRefused(MeshFiles.gltf(SURFACE, "none.bin"), "is missing");
        for (String uri : List.of("http://127.0.0.1:9/a.bin", "file:///etc/passwd", "HTTPS:x")) {
            assertRefused(MeshFiles.gltf(SURFACE, uri), "nothing is fetched");
        }
    }

    @Test
    void invalidGltfIsRefusedInOneLine() {
        String good = MeshFiles.gltf(SURFACE);
        assertRefusedAfterReplacing(good, "\"2.0\"", "\"1.0\"", "version \"1.0\"");
        assertRefusedAfterReplacing(good, "\"scenes\"", "\"stages\"", "no scene");
        assertRefusedAfterReplacing(good, "\"POSITION\":0", "\"POSITION\":9", "accessor 9 of 5");
        assertRefusedAfterReplacing(good, "\"indices\":4", "\"indices\":-1", "accessor -1");
        assertRefusedAfterReplacing(good, "\"byteStride\":48", "\"byteStride\":252", "needs");
        assertRefusedAfterReplacing(good, "\"type\":\"SCALAR\"", "\"type\":\"VEC2\"", "not 1 numbers each");
        assertRefusedAfterReplacing(good, "\"NORMAL\":1", "\"NORMAL\":4", "elements of");
        assertRefusedAfterReplacing(good, "[{\"mesh\":0}]", "[{\"mesh\":0,\"children\":[0]}]", "two parents");
        assertRefusedAfterReplacing(good, "[{\"mesh\":0}]", "[{\"mesh\":0,\"skin\":0}]", "skeleton");
        assertRefusedAfterReplacing(good, "[{\"mesh\":0}]", "[{\"mesh\":0,\"weights\":[0.5]}]", "weights of targets");
        assertRefusedAfterReplacing(good, "[{\"mesh\":0}]", "[{\"mesh\":0,\"scale\":[1e30,1,1]}]", "no finite number");
        assertRefusedAfterReplacing(
                good, "{\"asset\"", "{\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\"", "KHR_draco");
        assertRefusedAfterReplacing(
                good, "[{\"mesh\":0}]", "[{\"mesh\":0,\"rotation\":[0,0,0,0]}]", "node 0 has the rotation [0,0,0,0]");
        String compressed = "\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}";
        assertRefused(good.replaceFirst("\"uri\":\"[^\"]*\"", compressed), "EXT_meshopt_compression");
        assertRefused(MeshFiles.gltf(SURFACE, "a%zz.bin"), "\"a%zz.bin\" has a % without two hexadecimal digits");
        assertRefusedAfterReplacing(good, "\"count\":216", "\"count\":2000000000", "1 to 6000000");
        assertRefusedAfterReplacing(good, "base64,", "base64,?", "no base64");
        assertRefused("{\"a\":", "no valid JSON");
        assertRefused("{\"a\":" + "[".repeat(5000), "no valid JSON");
        assertRefused("{}", "version \"\"");
    }

    private void assertRefusedAfterReplacing(String good, String from, String to, String words) {
        assertThat(good).contains(from);
        assertRefused(good.replace(from, to), words);
    }

    private static String header(int vertices, String element, String list) {
        return "ply\nformat ascii 1.0\nelement vertex " + vertices
                + "\nproperty float x\nproperty float y\nproperty float z\nelement " + element + "\nproperty list "
                + list
                + "\nend_header\n";
    }

    /** A strip of two triangles, an end, one of one triangle, an end. All face upwards. */
    @Test
    void stripsAreTriangles() throws IOException {
        String header = header(5, "tristrips 1", "int int vertex_indices") + "0 0 0  1 0 0  0 1 0  1 1 0  2 2 0\n";
        Mesh mesh = read(header + "9 0 1 2 3 -1 1 4 2 -1\n").mesh();
        assertThat(mesh.triangles()).isEqualTo(3);
        for (int triangle = 0; triangle < 3; triangle++) {
            assertThat(MeshChecks.areaNormal(mesh, triangle).z).isPositive();
        }
        assertRefused(header + "4 0 1 2 5\n", "tristrips 0: it names vertex 5");
        assertRefused(header + "4 0 1 2 -2\n", "tristrips 0: it names vertex -2");
        assertRefused(header + "7000000 0 1 2\n", "0 to 6000000 can be used");
        assertRefused(header.replace("vertex_indices", "strips") + "3 0 1 2\n", "no list vertex_indices");
        assertRefused(header + "2 0 1\n", "no faces");
    }

    @Test
    void invalidPlyIsRefusedInOneLine() {
        String header = header(3, "face 1", "uchar int vertex_indices");
        String places = "0 0 0\n1 0 0\n0 1 0\n";
        assertRefused(header + places + "3 0 1 3\n", "face 0: it names vertex 3");
        assertRefused(header + places + "2 0 1\n", "2 corners");
        assertRefused(header + places + "3 0 1 0.5\n", "vertex 0.5");
        assertRefused(header + places, "face 0: the file ends within it");
        assertRefused(header + "0 0 0\n1 nan 0\n", "vertex 1: \"nan\" is no number");
        assertRefused(header + "0 0 0\n1 NaN 0\n", "vertex 1: NaN is no finite number");
        assertRefused(
                header.replace("face 1", "face 10000000") + places, "10000000 rows of element face; at most 2000000");
        assertRefused(header.replace("float z", "float w") + places, "not x, y and z");
        assertRefused(header.replace("float z", "real z") + places, "line 6");
        assertRefused(header.replace("vertex_indices", "corners") + places, "no list vertex_indices");
        assertRefused("ply\nformat ascii 1.0\nend_header\n", "no face");
        assertRefused("ply\n", "line 2 of the header");
    }

    @Test
    void cornersOfPlyHaveTextureCoordinatesOfTheirOwn() throws IOException {
        String text = header(4, "face 1", "uchar int vertex_index\nproperty list uchar float texcoord") + """
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
