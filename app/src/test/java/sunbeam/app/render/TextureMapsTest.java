package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;
import static sunbeam.app.scene.SceneSettings.ORIENTATION_MAP;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Images on a mesh's texture coordinates: orientation maps, compared with a constant rotation, and maps of several patches. */
class TextureMapsTest extends InAScene {
    private static final int WIDTH = 36;
    private static final int HEIGHT = 28;
    // Towards 30.2 degrees: (110, 64) of eight bits about 128.
    private static final int SLANTED = 0x80ee_c000;
    private static final double SLANT = Math.atan2(64, 110);

    private String directions(int... argb) throws IOException {
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
        float[] mapped = drawn(mapped(plain, directions(SLANTED, SLANTED), 0.1), WIDTH, HEIGHT);

        float brightest = turned[4 * byLuminance(turned)[0] + 1];
        assertThat(brightest).isGreaterThan(0);
        // Directions in single precision on an order's flank, whose logarithm has a slope of 500.
        assertThat(mapped).containsExactly(turned, within(1e-3f * brightest));
    }

    @Test
    void movingPicturesTurnAlike() throws IOException {
        Choices quick = Choices.none().with(Methods.METHOD, TableMethod.TYPE).with(MethodSettings.TOLERANCE, 0.05);
        Scene plain = blaze().withMethod(new SceneMethod(quick));
        SceneData turned = load(mapped(plain, "none", SLANT));
        SceneData mapped = loader().parts(mapped(plain, directions(SLANTED), 0), List.of(turned), share -> {})
                .get(0);
        try (SceneSession session = new SceneSession(context, turned)) {
            picture(session, WIDTH, HEIGHT);
            int[] before = moving(session, WIDTH, HEIGHT);
            session.update(mapped);

            // Angles are packed in steps of a hundredth of a degree: an order's flank may move by a few of 255.
            assertAlike(moving(session, WIDTH, HEIGHT), before, 4);
            assertThat(IntStream.of(before).filter(rgb -> rgb != 0xff204060).count())
                    .as("pixels without background")
                    .isGreaterThan(WIDTH);
        }
    }

    @Test
    void eachPlaceHasItsOwnDirection() throws IOException {
        String halves = directions(0xffff8000, 0xffff8000, 0xff80ff00, 0xff80ff00);
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
        try (SceneSession session = session(mapped(mirrored, directions(0xff80ff00), 0.2))) {
            assertPointsTo(tangent(session, WIDTH / 2), Math.PI / 2 + 0.2);
        }
        try (SceneSession session = session(mapped(mirrored, directions(SLANTED), 0))) {
            assertPointsTo(tangent(session, WIDTH / 2), Math.PI - SLANT);
        }
    }

    @Test
    void mapsWithoutDirectionsAreRefused() throws IOException {
        assertRefused(directions(0xffc8_c8c8, 0xffc8_c8c8), "is gray");
        assertRefused(directions(0xff80_8080, 0xff80_8080), "has no direction in column 0");
        assertRefused(directions(0xff86_827f, 0xff86_827f), "has no direction in column 0");
        assertRefused(folder + "/none.png", "there is no orientation map");
    }

    private void assertRefused(String map, String complaint) {
        assertThatThrownBy(() -> load(mapped(blaze(), map, 0)))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll(map, complaint);
    }

    private static final int RED = 0xff0000;
    private static final int BLUE = 0x0000ff;

    /** A square of 2 x 2 texels, the upper row first. */
    private String map(int type, int... rgb) throws IOException {
        return image(
                type, 2, Arrays.stream(rgb).map(color -> 0xff00_0000 | color).toArray());
    }

    private static PatchAtlas.Region region(int color, String patch) {
        return new PatchAtlas.Region(new SceneColor(color), PatchRequest.of(patch));
    }

    private static Scene scene(String map, PatchAtlas.Region... regions) {
        return blaze().withPatches(new PatchAtlas(map, List.of(regions)));
    }

    private float[] drawn(Scene scene) {
        return sum(parts(scene), WIDTH, HEIGHT).rgba();
    }

    private int regionAt(SceneSession session, int x, int y) {
        return session.pick(x, y, WIDTH, HEIGHT).orElseThrow().region();
    }

    /** Blaze on the right and below, a flatter one on the left above; over a body, so that the blend is the sum's. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void eachPlaceLooksLikeItsPatch(boolean byTable) throws IOException {
        Choices quick = Choices.none()
                .with(Methods.METHOD, byTable ? TableMethod.TYPE : FullMethod.TYPE)
                .with(MethodSettings.TOLERANCE, 0.05);
        Scene both = scene(
                        map(BufferedImage.TYPE_INT_RGB, RED, BLUE, BLUE, BLUE),
                        region(BLUE, "blaze"),
                        region(RED, "lamellar"))
                .withMethod(new SceneMethod(quick))
                .with(Weights.of(3000, 1, 1, 0));
        float[] mixed = drawn(both);
        float[][] alone = {
            drawn(both.withPatch(PatchRequest.of("blaze"))), drawn(both.withPatch(PatchRequest.of("lamellar")))
        };

        int[] places = new int[2];
        int different = 0;
        try (SceneSession session = new SceneSession(context, parts(both).get(1))) {
            for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
                if (mixed[4 * pixel + 3] == 0) {
                    continue;
                }
                int region = regionAt(session, pixel % WIDTH, pixel / WIDTH);
                places[region]++;
                for (int c = 4 * pixel; c < 4 * pixel + 3; c++) {
                    // Light is added to the body on the processor, not on the graphics card: single precision.
                    assertThat(mixed[c]).isCloseTo(alone[region][c], withinPercentage(0.01));
                    different += Math.abs(alone[0][c] - alone[1][c]) > 0.01 ? 1 : 0;
                }
            }
            assertThat(regionAt(session, WIDTH / 2 - 4, HEIGHT / 2 - 4)).isOne();
            assertThat(regionAt(session, WIDTH / 2 + 4, HEIGHT / 2 - 4)).isZero();
            assertThat(regionAt(session, WIDTH / 2 - 4, HEIGHT / 2 + 4)).isZero();
        }
        assertThat(places[1]).isBetween(places[0] / 4, places[0] / 2);
        assertThat(different).as("the patches differ").isGreaterThan(20);
    }

    /** Gray, indexed and 16-bit images. */
    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_BYTE_BINARY, BufferedImage.TYPE_USHORT_GRAY})
    void blackAndWhiteMapsOfAllKindsAreRead(int type) throws IOException {
        Scene scene = scene(map(type, 0, 0, 0xffffff, 0xffffff), region(0, "blaze"), region(0xffffff, "lamellar"));

        assertThat(parts(scene)).extracting(part -> part.patch().name()).containsExactly("blaze", "lamellar");
    }

    @Test
    void colorsWithoutPatchAndPatchesWithoutPlaceAreRefused() throws IOException {
        String map = map(BufferedImage.TYPE_INT_RGB, RED, BLUE, 0x7f007f, BLUE);
        PatchAtlas.Region red = region(RED, "blaze");
        PatchAtlas.Region blue = region(BLUE, "lamellar");
        PatchAtlas.Region mean = region(0x7f007f, "lamellar");

        assertThatThrownBy(() -> parts(scene(map, red, blue)))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll(
                        map, "has #7f007f in column 0, row 1, which has no patch; known are #0000ff, #ff0000");
        assertThatThrownBy(() -> parts(scene(map, red, blue, mean, region(0x00ff00, "blaze"))))
                .hasMessageContaining("has nowhere #00ff00");
        assertThatThrownBy(() -> parts(scene(folder + "/none.png", red))).hasMessageContaining("there is no patch map");
    }

    @Test
    void noMoreThanEightPatches() {
        List<PatchAtlas.Region> many = new ArrayList<>();
        for (int i = 0; i <= PatchAtlas.MOST; i++) {
            many.add(region(i, "blaze"));
        }
        assertThatThrownBy(() -> new PatchAtlas("m.png", many)).hasMessageContaining("at most 8");
    }
}
