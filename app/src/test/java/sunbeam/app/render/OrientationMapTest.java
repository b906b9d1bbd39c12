package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.scene.SceneSettings.ORIENTATION_MAP;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Orientation maps on a mesh, compared with a constant rotation. */
class OrientationMapTest extends InAScene {
    private static final int WIDTH = 36;
    private static final int HEIGHT = 28;
    // Towards 30.2 degrees: (110, 64) of eight bits about 128.
    private static final int SLANTED = 0x80ee_c000;
    private static final double SLANT = Math.atan2(64, 110);

    private String map(int... argb) throws IOException {
        return image(BufferedImage.TYPE_INT_ARGB, argb.length, argb);
    }

    private static Scene mapped(Scene scene, String map, double turn) {
        return scene.with(Choices.none().with(ORIENTATION_MAP, map).with(ROTATE_PATCH, turn));
    }

    private static Vector3fc tangent(SceneSession session, int x) {
        return session.pick(x, HEIGHT / 2, WIDTH, HEIGHT).orElseThrow().tangent();
    }

    private static void assertPointsTo(Vector3fc direction, double radians) {
        Vector3f expected = new Vector3f((float) Math.cos(radians), (float) Math.sin(radians), 0);
        // Single precision.
        assertThat(direction.distance(expected)).isLessThan(1e-5f);
    }

    /** For any alpha of the map, and in addition to a rotation. */
    @Test
    void aConstantMapIsATurnOfThePatch() throws IOException {
        Scene plain = blaze();
        float[] turned = drawn(mapped(plain, "none", SLANT + 0.1), WIDTH, HEIGHT);
        float[] mapped = drawn(mapped(plain, map(SLANTED, SLANTED), 0.1), WIDTH, HEIGHT);

        float brightest = 0;
        for (int i = 1; i < turned.length; i += 4) {
            brightest = Math.max(brightest, turned[i]);
        }
        assertThat(brightest).isGreaterThan(0);
        // Directions in single precision on an order's flank, whose logarithm has a slope of 500.
        assertThat(mapped).containsExactly(turned, within(1e-3f * brightest));
    }

    @Test
    void movingPicturesTurnAlike() throws IOException {
        Choices quick = Choices.none().with(Methods.METHOD, TableMethod.TYPE).with(MethodSettings.TOLERANCE, 0.05);
        Scene plain = blaze().withMethod(new SceneMethod(quick));
        SceneData turned = load(mapped(plain, "none", SLANT));
        SceneData mapped = loader().parts(mapped(plain, map(SLANTED), 0), List.of(turned), share -> {})
                .get(0);
        try (SceneSession session = new SceneSession(context, turned)) {
            picture(session, WIDTH, HEIGHT);
            BufferedImage before = session.moving(WIDTH, HEIGHT, 1, 1);
            session.update(mapped);
            BufferedImage after = session.moving(WIDTH, HEIGHT, 1, 1);

            int lit = 0;
            for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
                int one = before.getRGB(pixel % WIDTH, pixel / WIDTH);
                int other = after.getRGB(pixel % WIDTH, pixel / WIDTH);
                for (int shift = 0; shift < 24; shift += 8) {
                    // Angles are packed in steps of a hundredth of a degree: an order's flank may move by a few of 255.
                    assertThat(other >> shift & 0xff).isCloseTo(one >> shift & 0xff, within(4));
                }
                lit += one == 0xff204060 ? 0 : 1;
            }
            assertThat(lit).isGreaterThan(WIDTH);
        }
    }

    @Test
    void eachPlaceHasItsOwnDirection() throws IOException {
        String halves = map(0xffff8000, 0xffff8000, 0xff80ff00, 0xff80ff00);
        try (SceneSession session = session(mapped(blaze(), halves, 0.2))) {
            // Left: along u, turned; right: along v, turned. Either has two texels, between which it does not change.
            assertPointsTo(tangent(session, WIDTH / 2 - 5), 0.2);
            assertPointsTo(tangent(session, WIDTH / 2 + 4), Math.PI / 2 + 0.2);
            float[] all = session.patchDirections(WIDTH, HEIGHT);
            int pixel = 3 * (HEIGHT / 2 * WIDTH + WIDTH / 2 + 4);
            assertPointsTo(new Vector3f(all[pixel], all[pixel + 1], all[pixel + 2]), Math.PI / 2 + 0.2);
            assertThat(all[0]).as("no skin").isZero();
        }
    }

    /** If u runs to the left, so does the tangent; green is still along v. */
    @Test
    void greenIsAlongVWhereTheTextureIsMirrored() throws IOException {
        Path mesh = Files.writeString(folder.resolve("mirrored.obj"), """
                v -0.1 -0.1 0
                v 0.1 -0.1 0
                v 0.1 0.1 0
                v -0.1 0.1 0
                vt 1 0
                vt 0 0
                vt 0 1
                vt 1 1
                f 1/1 2/2 3/3 4/4
                """);
        Scene mirrored = blaze().withMesh(MeshSource.of(mesh.toString()));
        try (SceneSession session = session(mapped(mirrored, map(0xff80ff00), 0.2))) {
            assertPointsTo(tangent(session, WIDTH / 2), Math.PI / 2 + 0.2);
        }
        try (SceneSession session = session(mapped(mirrored, map(SLANTED), 0))) {
            assertPointsTo(tangent(session, WIDTH / 2), Math.PI - SLANT);
        }
    }

    @ParameterizedTest
    @CsvSource({"c8c8c8, is gray", "808080, has no direction in column 0", "86827f, has no direction in column 0"})
    void mapsWithoutDirectionsAreRefused(String color, String complaint) throws IOException {
        String map = map(0xff00_0000 | Integer.parseInt(color, 16), 0xff00_0000 | Integer.parseInt(color, 16));

        assertThatThrownBy(() -> load(mapped(blaze(), map, 0)))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll(map, complaint);
    }

    @Test
    void aMapThatIsNotThereIsRefused() {
        Scene scene = mapped(blaze(), folder.resolve("none.png").toString(), 0);

        assertThatThrownBy(() -> load(scene))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("there is no orientation map");
    }
}
