package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.files.input.JsonVariants;
import sunbeam.precompute.files.InputException;

/** Properties of glTF alone: extensions, quantized numbers, JSON documents without a mesh. */
class GltfReaderTest extends MeshReading {
    private static final Mesh PLANE = BuiltInMeshes.plane(1, 1);
    private static final String GOOD = MeshFiles.gltf(PLANE);

    private String refusal(String json) {
        InputException refused = catchThrowableOfType(InputException.class, () -> read(json));
        return refused == null ? "" : refused.getMessage();
    }

    private static String textured(String material) {
        return GOOD.replace("\"indices\":4", "\"indices\":4,\"material\":0")
                .replace("\"accessors\"", "\"materials\":[{" + material + "}],\"accessors\"");
    }

    private static String transformed(String transform) {
        return "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{"
                + transform + "}}}}";
    }

    private float[] bounds(String json) throws IOException {
        Mesh mesh = read(json).mesh();
        float[] bounds = {Float.MAX_VALUE, Float.MAX_VALUE, -Float.MAX_VALUE, -Float.MAX_VALUE};
        for (int i = 0; i < mesh.textureCoordinates().length; i++) {
            bounds[i % 2] = Math.min(bounds[i % 2], mesh.textureCoordinates()[i]);
            bounds[2 + i % 2] = Math.max(bounds[2 + i % 2], mesh.textureCoordinates()[i]);
        }
        return bounds;
    }

    @Test
    void aByteOrderMarkIsSkipped() throws IOException {
        assertThat(read("\u00ef\u00bb\u00bf" + GOOD).mesh().positions())
                .isEqualTo(read(GOOD).mesh().positions());
    }

    /**
     * The extension's first example shows the lower left quadrant turned by 90 degrees; the second turns v over, which leaves 0
     * to 1. Here v grows upwards.
     */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            '"offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5]' | 0 | 0 | 0.5 | 0.5
            '"offset":[0,1],"scale":[1,-1]'                              | 0 | 0 | 1   | 1
            '"scale":[3,2]'                                                | 0 | -1 | 3  | 1
            '"offset":[0.25,0.5]'                                          | 0.25 | -0.5 | 1.25 | 0.5
            ''                                                               | 0 | 0 | 1   | 1
            """)
    void textureTransformsAreApplied(String transform, float u, float v, float toU, float toV) throws IOException {
        // Float32 angles and coordinates.
        assertThat(bounds(textured(transformed(transform))))
                .containsExactly(new float[] {u, v, toU, toV}, within(1e-6f));
    }

    @Test
    void aTransformMayNameOtherCoordinates() throws IOException {
        String other = textured(transformed("\"texCoord\":1,\"scale\":[2,2]"))
                .replace("\"TEXCOORD_0\":3", "\"TEXCOORD_0\":9,\"TEXCOORD_1\":3");
        assertThat(bounds(other)[2]).isEqualTo(2);
        assertThat(bounds(other.replace("baseColorTexture", "metallicRoughnessTexture"))[2])
                .isEqualTo(2);
        assertThat(bounds(textured("\"normalTexture\":{\"index\":0,\"texCoord\":1}")
                        .replace("\"TEXCOORD_0\":3", "\"TEXCOORD_1\":3"))[2])
                .isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"\"scale\":2", "\"scale\":[1,null]", "\"rotation\":\"x\"", "\"texCoord\":null", "\"offset\":[1]"
            })
    void damagedTransformsAreRefusedByName(String transform) {
        assertThat(refusal(textured(transformed(transform)))).contains("KHR_texture_transform cannot be understood");
    }

    /** A horizontal square of 1 x 1 at x = 0, at 2 turned by 90 degrees about x, and at 4 in twice its size. */
    private static String instanced(String attributes) {
        ByteBuffer bytes = ByteBuffer.allocate(120).order(ByteOrder.LITTLE_ENDIAN);
        float root = (float) Math.sqrt(0.5);
        float[] moves = {0, 0, 0, 2, 0, 0, 4, 0, 0};
        float[] turns = {0, 0, 0, 1, root, 0, 0, root, 0, 0, 0, 1};
        float[] scales = {1, 1, 1, 1, 1, 1, 2, 2, 2};
        for (float[] values : List.of(moves, turns, scales)) {
            for (float value : values) {
                bytes.putFloat(value);
            }
        }
        String extension = "\"EXT_mesh_gpu_instancing\":{\"attributes\":{" + attributes + "}}";
        String added = String.join(
                ",", accessor(0, 3, "VEC3"), accessor(36, 3, "VEC4"), accessor(84, 3, "VEC3"), accessor(0, 2, "VEC3"));
        String buffer = "{\"uri\":\"" + MeshFiles.dataUri(bytes.array()) + "\",\"byteLength\":120}";
        return GOOD.replace("{\"mesh\":0}", "{\"mesh\":0,\"extensions\":{" + extension + "}}")
                .replace("\"type\":\"SCALAR\"}]", "\"type\":\"SCALAR\"}," + added + "]")
                .replace("],\n\"buffers\":[", ",{\"buffer\":1,\"byteLength\":120}],\n\"buffers\":[")
                .replaceFirst("}]}\\s*$", "}," + buffer + "]}");
    }

    private static String accessor(int offset, int count, String type) {
        return "{\"bufferView\":2,\"componentType\":5126,\"byteOffset\":" + offset + ",\"count\":" + count
                + ",\"type\":\"" + type + "\"}";
    }

    @Test
    void instancesArePlaced() throws IOException {
        Mesh mesh =
                read(instanced("\"TRANSLATION\":5,\"ROTATION\":6,\"SCALE\":7")).mesh();

        assertThat(mesh.triangles()).isEqualTo(3 * PLANE.triangles());
        // Float32 coordinates of order 5.
        assertThat(MeshChecks.area(mesh)).isCloseTo(6, within(1e-5));
        assertThat(mesh.side(0)).isCloseTo(5.5, within(1e-5));
        assertThat(mesh.side(2)).as("the turned one is upright").isCloseTo(1, within(1e-5));
        assertThat(read(instanced("\"TRANSLATION\":5")).mesh().side(0)).isCloseTo(5, within(1e-5));
    }

    @Test
    void aMeshAtSeveralPlacesIsOneObject() throws IOException {
        String twice = "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"matrix\":[-2,0,0,0,0,1,0,0,0,0,1,0,5,0,0,1]}]";
        for (String text : List.of(
                instanced("\"TRANSLATION\":5,\"ROTATION\":6,\"SCALE\":7"),
                GOOD.replace("\"nodes\":[0]", "\"nodes\":[0,1]").replace("\"nodes\":[{\"mesh\":0}]", twice))) {
            MeshSource.Loaded read = read(text);
            Mesh joined = Mesh.joined(read.parts());

            assertThat(read.parts()).hasSizeGreaterThan(1);
            assertThat(read.parts())
                    .extracting(MeshSource.Part::mesh)
                    .containsOnly(read.parts().get(0).mesh());
            // Float32 coordinates of order 5.
            for (int triangle = 0; triangle < joined.indices().length; triangle += 3) {
                assertThat(areaNormal(joined, triangle).distance(areaNormal(read.mesh(), triangle)))
                        .as("area and front")
                        .isLessThan(1e-5);
                assertThat(sum(joined, joined.positions(), triangle)
                                .distance(sum(read.mesh(), read.mesh().positions(), triangle)))
                        .isLessThan(1e-5);
                assertThat(sum(joined, joined.normals(), triangle)
                                .distance(sum(read.mesh(), read.mesh().normals(), triangle)))
                        .isLessThan(1e-5);
            }
        }
        assertThat(read(GOOD).parts()).hasSize(1);
    }

    /** Sum over a triangle's corners. */
    private static Vector3d sum(Mesh mesh, float[] values, int first) {
        Vector3d sum = new Vector3d();
        for (int corner = first; corner < first + 3; corner++) {
            sum.add(Mesh.vector(values, mesh.indices()[corner]));
        }
        return sum;
    }

    private static Vector3d areaNormal(Mesh mesh, int first) {
        Vector3d origin = Mesh.vector(mesh.positions(), mesh.indices()[first]);
        Vector3d along =
                Mesh.vector(mesh.positions(), mesh.indices()[first + 1]).sub(origin);
        return along.cross(
                Mesh.vector(mesh.positions(), mesh.indices()[first + 2]).sub(origin));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            "TRANSLATION":5,"ROTATION":8 | node 0 has
            "TRANSLATION":5,"SCALE":8    | and 3 by another attribute
            "TRANSLATION":99             | accessor 99
            "TRANSLATION":"x"            | cannot be understood
            "TRANSLATION":6              | has not 3 numbers
            "COLOR":5                    | cannot be understood
            """)
    void damagedInstancesAreRefusedByName(String attributes, String complaint) {
        assertThat(refusal(instanced(attributes))).contains(complaint);
    }

    @Test
    void aHiddenNodeAndThoseBelowItAreNotRead() throws IOException {
        String hidden = "\"extensions\":{\"KHR_node_visibility\":{\"visible\":false}}";
        String nodes = "\"nodes\":[{\"mesh\":0},{" + hidden + ",\"mesh\":0,\"children\":[2]},{\"mesh\":0}]";
        String three = GOOD.replace("\"nodes\":[0]", "\"nodes\":[0,1]").replace("\"nodes\":[{\"mesh\":0}]", nodes);

        assertThat(read(three).mesh().triangles()).isEqualTo(PLANE.triangles());
        assertThat(read(three.replace("false", "true")).mesh().triangles()).isEqualTo(3 * PLANE.triangles());
        assertThat(refusal(three.replace("false", "1"))).contains("KHR_node_visibility");
        String loop = "\"nodes\":[{\"mesh\":0,\"children\":[0]}]";
        assertThat(refusal(GOOD.replace("\"nodes\":[{\"mesh\":0}]", loop))).contains("node 0", "contains itself");
    }

    /** A triangle of twice its unit in x; its numbers may be of any kind that the extension allows. */
    @ParameterizedTest
    @CsvSource({
        "5120, false, 1", "5121, false, 1", "5122, false, 1", "5123, false, 1",
        "5120, true, 127", "5121, true, 255", "5122, true, 32767", "5123, true, 65535"
    })
    void quantizedPositionsAreRead(int type, boolean normalized, int one) throws IOException {
        int[] positions = {0, 0, 0, one, 0, 0, 0, one, 0};
        int size = type < 5122 ? 1 : 2;
        ByteBuffer bytes = ByteBuffer.allocate(24).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < 9; i++) {
            // Vertices begin at multiples of four bytes.
            int at = i / 3 * 4 * size + i % 3 * size;
            if (size == 1) {
                bytes.put(at, (byte) positions[i]);
            } else {
                bytes.putShort(at, (short) positions[i]);
            }
        }
        Mesh mesh = read("""
                {"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],"scenes":[{"nodes":[0]}],
                "nodes":[{"mesh":0,"scale":[2,1,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
                "accessors":[{"bufferView":0,"componentType":%d,"normalized":%b,"count":3,"type":"VEC3"}],
                "bufferViews":[{"buffer":0,"byteLength":24,"byteStride":%d}],"buffers":[{"uri":"%s","byteLength":24}]}
                """.formatted(type, normalized, 4 * size, MeshFiles.dataUri(bytes.array())))
                .mesh();
        assertThat(MeshChecks.areaNormal(mesh, 0).length()).isCloseTo(2, within(1e-6));
    }

    @Test
    void messagesOfTheParserAreNotShown() {
        for (String broken :
                List.of("{\"a\":tru}", "{\"a\":1,,}", "{\"a\":\"\n\"}", "{} {", "{\"a\":01}", "[1]", "{", "nul")) {
            assertThat(refusal("{".equals(broken.substring(0, 1)) ? broken : "{\"scene\":" + broken))
                    .containsAnyOf("no valid JSON in line", "no glTF 2.0", "glTF of version")
                    .doesNotContainIgnoringCase("token")
                    .doesNotContainIgnoringCase("unexpected")
                    .doesNotContain("Source");
        }
    }

    /** Replaces each value of the document by null and by each kind of value; any other exception fails. */
    @Test
    void anyKindOfValueIsReadOrRefusedAnywhere() throws IOException {
        String rich = textured(transformed("\"offset\":[0,0],\"rotation\":0,\"scale\":[1,1],\"texCoord\":0"))
                .replace(
                        "[{\"mesh\":0}]",
                        "[{\"mesh\":0,\"children\":[1],\"weights\":[0]},{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}]")
                .replaceFirst(
                        "\"type\":\"VEC3\"",
                        "\"type\":\"VEC3\",\"normalized\":false,\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,"
                                + "\"componentType\":5125},\"values\":{\"bufferView\":1,\"byteOffset\":4}}");
        long refused = JsonVariants.of(rich).stream()
                .filter(json -> !refusal(json).isEmpty())
                .count();
        assertThat(refused).isGreaterThan(100);
    }

    /** 60,000 nodes that place 60,000 primitives without triangles; reading all of them would take hours. */
    @Test
    void manyNodesTimesManyPrimitivesAreRefused() {
        String roots = IntStream.range(0, 60_000).mapToObj(Integer::toString).collect(Collectors.joining(","));
        String json = "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[" + roots
                + "]}],\"nodes\":[{\"mesh\":0}"
                + ",{\"mesh\":0}".repeat(59_999) + "],\"meshes\":[{\"primitives\":[{\"attributes\":{},\"mode\":0}"
                + ",{\"mode\":0}".repeat(59_999) + "]}]}";
        assertThat(json.getBytes(StandardCharsets.UTF_8).length).isLessThan(3_000_000);
        assertThat(refusal(json)).contains("place more than 1000000 primitives; join the meshes");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            /meshes/0/primitives/0/indices | "x"
            /meshes/0/primitives/0/indices | null
            /meshes/0/primitives | [null]
            /bufferViews/1/byteOffset | null
            /accessors/0/byteOffset | -1
            /accessors/0/count | 2147483648
            /accessors/0/max | [1,"x",0]
            /nodes/0/scale | [2,3]
            /nodes/0/scale | []
            /nodes/0/matrix | [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0]
            /nodes/0/mesh | 0.5
            """)
    void aWrongValueIsRefusedByItsPath(String path, String value) throws IOException {
        ObjectMapper mapper = new ObjectMapper();
        JsonNode json = mapper.readTree(GOOD);
        int end = path.lastIndexOf('/');
        ((ObjectNode) json.at(path.substring(0, end))).set(path.substring(end + 1), mapper.readTree(value));
        assertThat(refusal(json.toString()))
                .contains("at \"" + path)
                .contains("which glTF 2.0 does not allow; repair it or export it again");
    }

    /** Empty lists and whole numbers such as 2.0 are common; unread properties may have any value. */
    @Test
    void harmlessValuesAreRead() throws IOException {
        String odd = textured("\"emissiveFactor\":[2,2,2]")
                .replaceFirst("\\{", "{\"animations\":[],\"cameras\":[null],\"extras\":{\"a\":null},")
                .replace("{\"mesh\":0}", "{\"mesh\":0.0,\"children\":[],\"extras\":{\"a\":null}}");
        assertThat(read(odd).mesh().indices()).hasSameSizeAs(PLANE.indices());
    }
}
