package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/** OBJ: its repair, units of its numbers, and coordinates of maps (UTM), thousands of kilometers from the origin. */
class MeshReaderTest extends MeshReading {
    private static final String SQUARE = """
            v 0 0 0
            v 1 0 0
            v 1 1 0
            v 0 1 0
            """;
    private static final String TEXTURE = """
            vt 0 0
            vt 1 0
            vt 1 1
            vt 0 1
            """;

    @Test
    void missingNormalsAreWeightedByArea() throws IOException {
        // Two triangles share an edge along y: one lies flat with area 1/2, one stands upright with area 1.
        MeshSource.Loaded read = read("""
                v 0 0 0
                v 0 1 0
                v -1 0 0
                v 0 0 2
                f 1 2 3
                f 1 4 2
                """);

        // Flat: (0, 0, 1) x 1/2. Upright: edge z x edge y = -x, area 1.
        Vector3d expected = new Vector3d(-1, 0, 0.5).normalize();
        assertThat(MeshChecks.normal(read.mesh(), read.mesh().indices()[0]).distance(expected))
                .isLessThan(MeshChecks.ROUNDING);
        assertThat(MeshChecks.normal(read.mesh(), read.mesh().indices()[2])).isEqualTo(new Vector3d(0, 0, 1));
        assertThat(read.warnings()).anyMatch(line -> line.contains("computed normals for 4 of 4 vertices"));
        MeshChecks.assertOrthonormalFrames(read.mesh());
    }

    /** Two squares of a gentle ridge and two of a right angle, each with vertices of its own along the edge that they share. */
    @ParameterizedTest
    @CsvSource({"0.2, 0", "1, 0.70710678"})
    void repeatedPositionsShareANormalUnlessTheEdgeIsHard(double depth, double expectedX) throws IOException {
        String ridge = "v -1 0 -D\nv 0 0 0\nv 0 1 0\nv -1 1 -D\nv 0 0 0\nv 1 0 -D\nv 1 1 -D\nv -0 1 0\n"
                .replace("D", Double.toString(depth));
        Mesh mesh = read(ridge + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n")
                .mesh();
        for (int vertex = 0; vertex < mesh.vertices(); vertex++) {
            if (mesh.positions()[3 * vertex] == 0) {
                assertThat(Math.abs(MeshChecks.normal(mesh, vertex).x)).isCloseTo(expectedX, within(1e-6));
            }
        }
    }

    @Test
    void tangentsFollowUAndMirroredTexturesAreLeftHanded() throws IOException {
        Mesh turned = read(SQUARE + "vt 0 0\nvt 0 1\nvt -1 1\nvt -1 0\nf 1/1 2/2 3/3 4/4\n")
                .mesh();
        Mesh mirrored = read(SQUARE + "vt 0 0\nvt -1 0\nvt -1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
                .mesh();

        // u grows against y in the first, against x in the second; v along x, and along y.
        assertThat(turned.tangents()).startsWith(0, -1, 0, 1);
        assertThat(mirrored.tangents()).startsWith(-1, 0, 0, -1);
        MeshChecks.assertTangentsFollowTheTexture(turned, 1 - 1e-6);
        MeshChecks.assertTangentsFollowTheTexture(mirrored, 1 - 1e-6);
    }

    @Test
    void missingTextureCoordinatesAreTheViewFromAbove() throws IOException {
        MeshSource.Loaded read = read("v 1 1 0\nv 3 1 0\nv 3 2 1\nv 1 2 1\nf 1 2 3 4\nf 4 3 2 1\n");
        Mesh mesh = read.mesh();

        assertThat(read.warnings()).anyMatch(line -> line.contains("texture coordinates are missing"));
        for (int vertex = 0; vertex < mesh.vertices(); vertex++) {
            Vector3d position = MeshChecks.position(mesh, vertex);
            assertThat(mesh.textureCoordinates()[2 * vertex]).isCloseTo((float) (position.x - 1) / 2, within(1e-6f));
            assertThat(mesh.textureCoordinates()[2 * vertex + 1])
                    .isCloseTo((float) (position.y - 1) / 2, within(1e-6f));
            assertThat(MeshChecks.tangent(mesh, vertex).distance(new Vector3d(1, 0, 0)))
                    .isLessThan(MeshChecks.ROUNDING);
            assertThat(mesh.tangents()[4 * vertex + 3]).isEqualTo(1);
        }
        // Back to back: the two faces keep their own normals.
        MeshChecks.assertNormalsFaceOutwards(mesh, 1 - 1e-6);
    }

    @Test
    void degenerateTrianglesAreDroppedAndCounted() throws IOException {
        MeshSource.Loaded read = read(SQUARE + "v 0.5 0.5 0\nf 1 2 3\nf 1 1 2\nf 1 5 3\nf 2 2 2\n");

        assertThat(read.mesh().triangles()).isEqualTo(1);
        assertThat(read.mesh().vertices()).isEqualTo(3);
        assertThat(read.warnings()).anyMatch(line -> line.endsWith("dropped 3 triangles without area"));
    }

    @Test
    void polygonsAreDividedAlsoConcaveOnes() throws IOException {
        // An arrow head: the fan from the first corner would leave the outline.
        Mesh arrow = read("v 2 0 0\nv 0 1 0\nv 0.5 0 0\nv 0 -1 0\nf 1 2 3 4\n").mesh();
        Mesh star = read(star()).mesh();

        assertThat(arrow.triangles()).isEqualTo(2);
        assertThat(MeshChecks.area(arrow)).isCloseTo(1.5, within(1e-6));
        MeshChecks.assertNormalsFaceOutwards(arrow, 1 - 1e-6);
        assertThat(star.triangles()).isEqualTo(18);
        // 20 triangles between radii 1 and 0.3 at angles of 18 degrees.
        assertThat(MeshChecks.area(star)).isCloseTo(20 * 0.5 * 0.3 * Math.sin(Math.PI / 10), within(1e-5));
        MeshChecks.assertNormalsFaceOutwards(star, 1 - 1e-5);
    }

    private static String star() {
        String points = IntStream.range(0, 20)
                .mapToObj(i -> new Vector3d(i % 2 == 0 ? 1 : 0.3, 0, 0)
                        .rotateZ(i * Math.PI / 10)
                        .rotateX(1)
                        .rotateY(0.5))
                .map(point -> "v " + point.x + " " + point.y + " " + point.z + "\n")
                .collect(Collectors.joining());
        return points + "f "
                + IntStream.rangeClosed(1, 20).mapToObj(Integer::toString).collect(Collectors.joining(" "));
    }

    @Test
    void theFormatsCornersAreRead() throws IOException {
        Mesh plain = read(SQUARE + TEXTURE + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n").mesh();
        Mesh odd = read("\u00EF\u00BB\u00BF# comment\r\no thing\r\n" + SQUARE + "vt 0\n"
                        + TEXTURE.replace("vt 0 0\n", "")
                        + "mtllib none.mtl\ng a b\nusemtl red # and more\ns off\nvn 0 0 1\nl 1 2\n"
                        + "f\t1/1/1 2/2/1\\\n 3/3/1 # last")
                .mesh();
        Mesh normalsOnly = read(SQUARE + "vn 0 0 1\nf 1//1 2//1 3//1\n").mesh();

        assertThat(odd.positions()).isEqualTo(plain.positions());
        assertThat(odd.textureCoordinates()).isEqualTo(plain.textureCoordinates());
        assertThat(normalsOnly.normals()).isEqualTo(plain.normals());
    }

    @Test
    void messagesNameWrongLines() {
        assertRefused("v 0 0 0\nv 1 NaN 0\n", "line 2", "NaN is no finite number");
        assertRefused("v 0 0 0\nvt 1e99 0\n", "line 2", "1.0E99");
        assertRefused("vn 0 -Infinity 0\n", "line 1");
        assertRefused("v 0 zero 0\n", "\"zero\" is no number");
        assertRefused("v 0 0\n", "position needs 3 numbers, not 2");
        assertRefused(SQUARE + "f 1 2\n", "line 5", "2 corners");
        assertRefused(SQUARE + "f 1 2 5\n", "line 5: the face names position 5 but 4");
        assertRefused(SQUARE + "f -1 -2 -9\n", "line 5: the face names position -9 but 4");
        assertRefused(SQUARE + "f 1 2 0\n", "\"0\"");
        assertRefused(SQUARE + "f 1 2 99999999999\n", "99999999999");
        for (String corner :
                List.of("/1", "1/", "1//", "1/1/", "1//1/1", "1/1/1/1", "-", "-0", "01", "1-", "+1", "1/x")) {
            assertRefused(SQUARE + "f 1 2 " + corner + "\n", "line 5: \"" + corner + "\" is no corner of a face");
        }
        assertRefused(SQUARE + "f 1/1 2/1 3/1\n", "texture coordinate 1 but 0");
        assertRefused(SQUARE + "f 1//1 2//1 3//1\n", "normal 1 but 0");
        assertRefused(SQUARE + TEXTURE + "f 1/1 2 3/3\n", "differ in kind");
    }

    @Test
    void filesWithoutFacesAreRefused() {
        assertRefused("", "no face");
        assertRefused(SQUARE, "no face");
        assertRefused(SQUARE + "f 1 1 2\n", "no face");
        assertRefused("\u0089PNG\r\n\u001A\n\u0000\u0000", "no face");
        assertRefused("x".repeat(100_000), "65536 characters");
        assertThatThrownBy(() -> MeshSource.read(folder.resolve("none.obj"), MeshSource.Unit.M))
                .hasMessageContaining("there is no such file");
        assertThatThrownBy(() -> MeshSource.read(folder, MeshSource.Unit.M)).hasMessageContaining("it is a folder");
    }

    @Test
    void tenMillionFacesAreRefusedBeforeMemoryIsTaken() throws IOException {
        Path file = folder.resolve("large.obj");
        String faces = "f 1 2 3\n".repeat(100_000);
        try (var writer = Files.newBufferedWriter(file)) {
            writer.write("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
            for (int i = 0; i < 100; i++) {
                writer.write(faces);
            }
        }

        assertThatThrownBy(() -> MeshSource.of(file.toString()).load())
                .isInstanceOf(InputException.class)
                .hasMessageEndingWith("large.obj: line 2000004: more than 2000000 triangles; simplify the mesh");
    }

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
        assertThat(MeshChecks.position(read.mesh(), read.mesh().indices()[2]).z)
                .isCloseTo(size * unit.meters, withinPercentage(1e-4));
        if (words == null) {
            assertThat(read.warnings()).isEmpty();
        } else {
            assertThat(read.warnings())
                    .singleElement()
                    .satisfies(line -> assertThat(line.replace(",", "")).contains(words));
        }
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
