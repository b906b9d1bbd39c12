package sunbeam.app.scene.mesh;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;

/**
 * Writes meshes as Wavefront OBJ; each number is the shortest decimal that reads back as the same float. The format has no tangents; {@link
 * sunbeam.app.scene.mesh.MeshReader} computes them.
 */
public final class ObjWriter {
    private ObjWriter() {}

    public static void write(OutputStream stream, Mesh mesh) throws IOException {
        // Unbuffered, writing takes twice as long.
        Writer writer = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.US_ASCII));
        writer.write(
                "# Sunbeam mesh: meters, z up; " + mesh.vertices() + " vertices, " + mesh.triangles() + " triangles\n");
        writeLines(writer, "v", mesh.positions(), 3);
        writeLines(writer, "vt", mesh.textureCoordinates(), 2);
        writeLines(writer, "vn", mesh.normals(), 3);
        int[] indices = mesh.indices();
        for (int i = 0; i < indices.length; i += 3) {
            writer.write("f");
            for (int corner = i; corner < i + 3; corner++) {
                String number = Integer.toString(indices[corner] + 1);
                writer.write(" " + number + "/" + number + "/" + number);
            }
            writer.write('\n');
        }
        writer.flush();
    }

    private static void writeLines(Writer writer, String kind, float[] values, int perLine) throws IOException {
        for (int i = 0; i < values.length; i += perLine) {
            writer.write(kind);
            for (int j = i; j < i + perLine; j++) {
                writer.write(" " + values[j]);
            }
            writer.write('\n');
        }
    }
}
