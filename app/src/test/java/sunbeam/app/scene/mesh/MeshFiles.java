package sunbeam.app.scene.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Text;

/** Meshes in the formats that Sunbeam reads, written as their specifications say and by none of its code. */
public final class MeshFiles {
    private MeshFiles() {}

    /** PLY with everything but tangents, at the file's beginning an element that is no geometry. */
    public static byte[] ply(Mesh mesh, String encoding) {
        String header = Text.format(
                "ply%nformat %s 1.0%ncomment a test%nelement camera 1%nproperty uchar focus%nproperty list uchar short rest%n"
                        + "element vertex %d%nproperty float x%nproperty float y%nproperty double z%nproperty float nx%n"
                        + "property float ny%nproperty float nz%nproperty uchar red%nproperty float s%nproperty float t%n"
                        + "element face %d%nproperty list uchar int vertex_indices%nend_header%n",
                encoding, mesh.vertices(), mesh.triangles());
        ByteBuffer bytes = ByteBuffer.allocate(200 * (mesh.vertices() + mesh.triangles()))
                .order(encoding.endsWith("little_endian") ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN)
                .put(header.getBytes(StandardCharsets.US_ASCII));
        Consumer<Number> sink = encoding.equals("ascii")
                ? number -> bytes.put((number + "\n").getBytes(StandardCharsets.US_ASCII))
                : number -> put(bytes, number);
        List.of((byte) 7, (byte) 2, (short) -1, (short) 3).forEach(sink);
        for (int i = 0; i < mesh.vertices(); i++) {
            float[] p = mesh.positions();
            float[] n = mesh.normals();
            float[] uv = mesh.textureCoordinates();
            List.of(p[3 * i], p[3 * i + 1], (double) p[3 * i + 2]).forEach(sink);
            List.of(n[3 * i], n[3 * i + 1], n[3 * i + 2]).forEach(sink);
            List.of((byte) 100, uv[2 * i], uv[2 * i + 1]).forEach(sink);
        }
        for (int i = 0; i < mesh.indices().length; i += 3) {
            sink.accept((byte) 3);
            IntStream.range(i, i + 3).mapToObj(corner -> mesh.indices()[corner]).forEach(sink);
        }
        return Arrays.copyOf(bytes.array(), bytes.position());
    }

    private static void put(ByteBuffer bytes, Number number) {
        if (number instanceof Byte value) {
            bytes.put(value);
        } else if (number instanceof Short value) {
            bytes.putShort(value);
        } else if (number instanceof Integer value) {
            bytes.putInt(value);
        } else if (number instanceof Float value) {
            bytes.putFloat(value);
        } else {
            bytes.putDouble((Double) number);
        }
    }

    /** Binary glTF with normals, tangents and texture coordinates. */
    public static byte[] glb(Mesh mesh) {
        return glb(gltf(mesh, null), buffer(mesh));
    }

    /** The two chunks of a binary file. */
    static byte[] glb(String json, byte[] buffer) {
        byte[] text = (json + " ".repeat((4 - json.length() % 4) % 4)).getBytes(StandardCharsets.US_ASCII);
        int length = 12 + 8 + text.length + 8 + buffer.length;
        ByteBuffer bytes = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(2).putInt(length);
        bytes.putInt(text.length)
                .put("JSON".getBytes(StandardCharsets.US_ASCII))
                .put(text);
        bytes.putInt(buffer.length).put(new byte[] {'B', 'I', 'N', 0}).put(buffer);
        return bytes.array();
    }

    static String dataUri(byte[] buffer) {
        return "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(buffer);
    }

    /** All vertices, y up and v downwards, 48 bytes each; then the indices. */
    static byte[] buffer(Mesh mesh) {
        ByteBuffer bytes = ByteBuffer.allocate(48 * mesh.vertices() + 4 * mesh.indices().length)
                .order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < mesh.vertices(); i++) {
            turned(bytes, mesh.positions(), 3 * i);
            turned(bytes, mesh.normals(), 3 * i);
            turned(bytes, mesh.tangents(), 4 * i);
            bytes.putFloat(mesh.tangents()[4 * i + 3]);
            bytes.putFloat(mesh.textureCoordinates()[2 * i]).putFloat(1 - mesh.textureCoordinates()[2 * i + 1]);
        }
        for (int index : mesh.indices()) {
            bytes.putInt(index);
        }
        return bytes.array();
    }

    private static void turned(ByteBuffer bytes, float[] values, int at) {
        bytes.putFloat(values[at]).putFloat(values[at + 2]).putFloat(-values[at + 1]);
    }

    /** A glTF text with its buffer in it. */
    public static String gltf(Mesh mesh) {
        return gltf(mesh, dataUri(buffer(mesh)));
    }

    /**
     * The text of {@link #buffer}.
     *
     * @param uri of the buffer, or null in a binary file
     */
    static String gltf(Mesh mesh, String uri) {
        int vertices = 48 * mesh.vertices();
        int indices = 4 * mesh.indices().length;
        return Text.format(
                """
                {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3},"indices":4}]}],
                "accessors":[%s,%s,%s,%s,{"bufferView":1,"componentType":5125,"count":%d,"type":"SCALAR"}],
                "bufferViews":[{"buffer":0,"byteLength":%d,"byteStride":48},{"buffer":0,"byteOffset":%d,"byteLength":%d}],
                "buffers":[{%s"byteLength":%d}]}
                """,
                accessor(0, mesh, "VEC3"),
                accessor(12, mesh, "VEC3"),
                accessor(24, mesh, "VEC4"),
                accessor(40, mesh, "VEC2"),
                mesh.indices().length,
                vertices,
                vertices,
                indices,
                uri == null ? "" : "\"uri\":\"" + uri + "\",",
                vertices + indices);
    }

    private static String accessor(int offset, Mesh mesh, String type) {
        return Text.format(
                "{\"bufferView\":0,\"byteOffset\":%d,\"componentType\":5126,\"count\":%d,\"type\":\"%s\"}",
                offset, mesh.vertices(), type);
    }
}
