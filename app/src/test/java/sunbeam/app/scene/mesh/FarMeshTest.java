package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.scene.mesh.format.MeshUnit;
import sunbeam.precompute.text.Text;

/** Meshes at coordinates of maps (UTM), thousands of kilometers from the origin. */
class FarMeshTest {
    private static final Mesh SPHERE = BuiltInMeshes.create("sphere");
    private static final Vector3d UTM = new Vector3d(500_000, 5_400_000, 300);

    @TempDir
    private Path folder;

    private byte[] obj(double x, double y, double z) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < SPHERE.vertices(); i++) {
            float[] p = SPHERE.positions();
            text.append(Text.format("v %.9f %.9f %.9f%n", p[3 * i] + x, p[3 * i + 1] + y, p[3 * i + 2] + z));
        }
        for (int i = 0; i < SPHERE.indices().length; i += 3) {
            int[] corners = SPHERE.indices();
            text.append(String.format("f %d %d %d%n", corners[i] + 1, corners[i + 1] + 1, corners[i + 2] + 1));
        }
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static String plyHeader(String encoding) {
        return String.format(
                "ply%nformat %s 1.0%nelement vertex %d%nproperty double x%nproperty double y%nproperty double z%n"
                        + "element face %d%nproperty list uchar int vertex_indices%nend_header%n",
                encoding, SPHERE.vertices(), SPHERE.triangles());
    }

    private static byte[] textPly() {
        StringBuilder text = new StringBuilder(plyHeader("ascii"));
        for (int i = 0; i < SPHERE.positions().length; i++) {
            text.append(Text.format("%.9f ", SPHERE.positions()[i] + UTM.get(i % 3)));
        }
        for (int i = 0; i < SPHERE.indices().length; i++) {
            text.append(i % 3 == 0 ? "3 " : "").append(SPHERE.indices()[i]).append('\n');
        }
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static byte[] binaryPly(ByteOrder order) {
        byte[] header = plyHeader(order == ByteOrder.BIG_ENDIAN ? "binary_big_endian" : "binary_little_endian")
                .getBytes(StandardCharsets.US_ASCII);
        ByteBuffer bytes = ByteBuffer.allocate(header.length + 24 * SPHERE.vertices() + 13 * SPHERE.triangles())
                .order(order)
                .put(header);
        for (int i = 0; i < SPHERE.positions().length; i++) {
            bytes.putDouble(SPHERE.positions()[i] + UTM.get(i % 3));
        }
        for (int i = 0; i < SPHERE.indices().length; i++) {
            if (i % 3 == 0) {
                bytes.put((byte) 3);
            }
            bytes.putInt(SPHERE.indices()[i]);
        }
        return bytes.array();
    }

    private ReadMesh read(byte[] content) throws IOException {
        return MeshReader.read(Files.write(folder.resolve("mesh"), content), MeshUnit.M);
    }

    private static double area(Mesh mesh) {
        double sum = 0;
        for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
            sum += 0.5 * MeshChecks.areaNormal(mesh, triangle).length();
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(strings = {"obj", "ascii", "little", "big"})
    void shapesSurviveFarFromTheOrigin(String format) throws IOException {
        ReadMesh far = read(
                switch (format) {
                    case "obj" -> obj(UTM.x, UTM.y, UTM.z);
                    case "ascii" -> textPly();
                    case "little" -> binaryPly(ByteOrder.LITTLE_ENDIAN);
                    default -> binaryPly(ByteOrder.BIG_ENDIAN);
                });
        assertThat(far.mesh().triangles()).isEqualTo(SPHERE.triangles());
        // Doubles have steps of 1e-9 m there, 1e-8 of the radius; edges of a hundredth of it.
        assertThat(area(far.mesh())).isCloseTo(area(SPHERE), within(1e-5 * area(SPHERE)));
        assertThat(far.warnings())
                .noneMatch(warning -> warning.contains("dropped"))
                .anyMatch(warning -> warning.contains("center (500000.000, 5400000.000, 300.000) m is moved"));
        assertThat(MeshChecks.position(far.mesh(), 0).length()).isLessThan(0.11);
    }

    @Test
    void meshesNearTheOriginStayWhereTheyAre() throws IOException {
        ReadMesh near = read(obj(50, 0, 0));
        assertThat(near.warnings()).noneMatch(warning -> warning.contains("moved"));
        assertThat(MeshChecks.position(near.mesh(), 0).x).isCloseTo(50, within(0.11));
    }
}
