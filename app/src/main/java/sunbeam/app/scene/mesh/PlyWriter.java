package sunbeam.app.scene.mesh;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import sunbeam.precompute.text.Text;

/** Writes meshes as binary PLY, little-endian: positions in meters, normals and texture coordinates, without tangents. */
public final class PlyWriter {
    private static final int VERTEX_BYTES = 8 * Float.BYTES;
    private static final int FACE_BYTES = 1 + 3 * Integer.BYTES;

    private PlyWriter() {}

    public static void write(OutputStream stream, Mesh mesh) throws IOException {
        stream.write(header(mesh).getBytes(StandardCharsets.US_ASCII));
        stream.write(content(mesh));
    }

    private static String header(Mesh mesh) {
        return Text.format("""
                ply
                format binary_little_endian 1.0
                comment Sunbeam mesh: meters, z up
                element vertex %d
                property float x
                property float y
                property float z
                property float nx
                property float ny
                property float nz
                property float s
                property float t
                element face %d
                property list uchar int vertex_indices
                end_header
                """, mesh.vertices(), mesh.triangles());
    }

    private static byte[] content(Mesh mesh) {
        ByteBuffer bytes = ByteBuffer.allocate(VERTEX_BYTES * mesh.vertices() + FACE_BYTES * mesh.triangles())
                .order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < mesh.vertices(); i++) {
            put(bytes, mesh.positions(), 3 * i, 3);
            put(bytes, mesh.normals(), 3 * i, 3);
            put(bytes, mesh.textureCoordinates(), 2 * i, 2);
        }
        for (int i = 0; i < mesh.indices().length; i++) {
            if (i % 3 == 0) {
                bytes.put((byte) 3);
            }
            bytes.putInt(mesh.indices()[i]);
        }
        return bytes.array();
    }

    private static void put(ByteBuffer bytes, float[] values, int from, int count) {
        for (int i = from; i < from + count; i++) {
            bytes.putFloat(values[i]);
        }
    }
}
