package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Placement;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneObject;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.MeshWriters;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Scenes of several objects. */
class SceneObjectsTest extends InAScene {
    private static final int WIDTH = 40;
    private static final int HEIGHT = 30;
    private static final Choices MIXED = Weights.of(3000, 1, 1, 0);

    private static SceneObject object(String mesh, String patch, Choices weights, Placement placement) {
        Choices settings = blaze().with(SceneSettings.MESH, mesh).with(weights).settings();
        return new SceneObject(settings, PatchAtlas.of(PatchRequest.of(patch)), placement);
    }

    private static Placement at(double x, double y, double z, double size) {
        return new Placement(new Vector3f((float) x, (float) y, (float) z), new Quaternionf(), OptionalDouble.of(size));
    }

    private static Scene scene(SceneObject... objects) {
        return blaze().withObjects(List.of(objects));
    }

    private static Scene quick(Scene scene, boolean byTable) {
        return scene.withMethod(new SceneMethod(Choices.none()
                .with(Methods.METHOD, byTable ? TableMethod.TYPE : FullMethod.TYPE)
                .with(MethodSettings.TOLERANCE, 0.05)));
    }

    private float[] drawn(Scene scene) {
        List<SceneSession> sessions = SceneSession.all(context, parts(scene));
        try {
            return new PartSum(sessions)
                    .draw(DrawRequest.ofPixels(scene, WIDTH, HEIGHT, jrtr.Tile.whole(WIDTH, HEIGHT), 1))
                    .rgba();
        } finally {
            sessions.forEach(SceneSession::close);
        }
    }

    private final SceneObject left = object("plane", "blaze", DIFFRACTION_ONLY, at(-0.09, 0, 0, 0.1));
    private final SceneObject right = object("sphere", "lamellar", MIXED, at(0.09, 0, 0, 0.08));

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void twoObjectsFarApartEqualTwoScenes(boolean byTable) {
        float[] both = drawn(quick(scene(left, right), byTable));
        float[] first = drawn(quick(scene(left), byTable));
        float[] second = drawn(quick(scene(right), byTable));

        int[] pixels = new int[3];
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            boolean showsFirst = first[4 * pixel + 3] > 0;
            boolean showsSecond = second[4 * pixel + 3] > 0;
            pixels[showsFirst ? 0 : showsSecond ? 1 : 2]++;
            float[] expected = showsSecond ? second : first;
            for (int c = 4 * pixel; c < 4 * pixel + 4; c++) {
                // The sum of light and body is rounded on the processor in one scene, on the graphics card in the
                // other.
                assertThat(both[c]).isCloseTo(expected[c], within(2e-6f + 1e-5f * expected[c]));
            }
        }
        assertThat(IntStream.of(pixels).min().orElseThrow())
                .as("each object, and the background")
                .isGreaterThan(40);
    }

    @Test
    void anObjectHasItsPlaceSizeAndOrientation() {
        Placement upright = new Placement(
                new Vector3f(0.02f, 0.03f, 0), new Quaternionf().rotationX(1.5f), OptionalDouble.of(0.05));
        Scene scene = scene(object("sphere", "blaze", DIFFRACTION_ONLY, upright), right);
        SceneShape shape = loader().shape(scene);

        // The sphere's radius is 0.1 m. A few operations in float32.
        Vector3f moved = shape.things().get(0).toModel().transformPosition(new Vector3f(0, 0.1f, 0));
        float across = 0.025f * (float) Math.cos(1.5);
        assertThat(moved.distance(0.02f, 0.03f + across, 0.025f * (float) Math.sin(1.5)))
                .isLessThan(1e-7f);
        assertThat(shape.whole().side(2)).isCloseTo(0.08, within(1e-6));
        assertThat(shape.whole().side(0)).isCloseTo(0.13 + 0.005, within(1e-4));
    }

    @Test
    void theNearerObjectHidesTheFartherOneAndIsPicked() {
        Scene scene = scene(left, object("sphere", "lamellar", MIXED, at(-0.09, 0, 0.05, 0.04)));
        List<SceneSession> sessions = SceneSession.all(context, parts(scene));
        PartSum sum = new PartSum(sessions);
        List<Integer> picked = new ArrayList<>();
        for (int x = 0; x < WIDTH; x++) {
            sum.pick(x, HEIGHT / 2, WIDTH, HEIGHT).map(Pick::object).ifPresent(picked::add);
        }
        sessions.forEach(SceneSession::close);

        assertThat(picked.stream().distinct()).as("from left to right").containsExactly(0, 1);
        assertThat(picked.get(picked.size() - 1))
                .as("the plane is on both sides")
                .isZero();
        float[] alone = drawn(scene(left));
        float[] both = drawn(scene);
        assertThat(IntStream.range(0, alone.length)
                        .filter(i -> both[i] != alone[i])
                        .count())
                .isGreaterThan(20);
    }

    @Test
    void anObjectShadesAnother() {
        SceneObject floor = object("plane", "blaze", Weights.of(0, 1, 1, 0), at(0, 0, 0, 0.2));
        SceneObject ball = object("sphere", "blaze", Weights.of(0, 1, 1, 0), at(-0.03, 0.045, 0.12, 0.05));
        Scene scene = scene(floor, ball).with(around(Optional.empty(), 0, true));
        float[] shaded = drawn(scene);
        float[] lit = drawn(scene.with(SceneSettings.SHADOWS, false));

        // The light comes from (-0.2, 0.3, 0.9): the ball's shadow lies around the origin, which is in the middle.
        int middle = 4 * (HEIGHT / 2 * WIDTH + WIDTH / 2) + 1;
        assertThat(shaded[middle]).isLessThan(0.05f * lit[middle]);
    }

    @Test
    void theGroundLiesBelowAllObjects() {
        Scene scene = scene(left, object("sphere", "blaze", MIXED, at(0.09, 0, -0.1, 0.08)))
                .with(around(Optional.of(new SceneColor(0x808080)), 0, false));
        float[] drawn = drawn(scene);

        assertThat(loader().shape(scene).bounds().radius()).isGreaterThan(0.1f);
        for (int alpha = 3; alpha < drawn.length; alpha += 4) {
            assertThat(drawn[alpha]).as("the ground fills what shows no object").isGreaterThan(0.99f);
        }
        // Diffraction alone has no ground.
        assertThat(drawn(scene(left).with(around(Optional.of(new SceneColor(0x808080)), 0, false))))
                .contains(0f);
    }

    @Test
    void equalLooksShareAPassAndEqualPatchesShareTables() {
        SceneObject twin = object("sphere", "blaze", DIFFRACTION_ONLY, at(0.09, 0, 0, 0.08));
        SceneObject brighter = object("disc", "blaze", Weights.of(2, 0, 0, 0), Placement.NONE);
        List<SceneData> parts = parts(scene(left, twin, brighter, right));

        assertThat(parts).extracting(SceneData::look).containsExactly(0, 2, 3);
        assertThat(parts.get(1).method()).isSameAs(parts.get(0).method());
        assertThat(parts.get(1).tables()).isSameAs(parts.get(0).tables());
        assertThat(parts.get(2).method()).isNotSameAs(parts.get(0).method());
        assertThat(parts.get(0).draws(1, 0)).as("the twin's patch").isTrue();
    }

    @Test
    void objectsOfAnySizesAreDrawn() {
        SceneObject speck = object("sphere", "lamellar", MIXED, at(0, 0, 0.1, 1e-7));
        Scene scene = scene(left, speck).with(around(Optional.of(new SceneColor(0x808080)), 0.3, true));
        float[] drawn = drawn(scene);

        for (float value : drawn) {
            assertThat(value).isFinite();
        }
        assertThat(drawn(scene(left, speck))).isEqualTo(drawn(scene(left)));
    }

    /** A file of a plane at two places, the second mirrored and tilted, is drawn as its joined mesh is. */
    @Test
    void instancesOfAFileAreDrawnFromOneMesh() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(92).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : new int[] {0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1, 0, 1, 1, 1, 1, 0, 0, 0}) {
            bytes.putFloat(value);
        }
        for (int index : new int[] {0, 1, 2, 0, 2, 3}) {
            bytes.putShort((short) index);
        }
        String data = Base64.getEncoder().encodeToString(bytes.array());
        Path file = folder.resolve("two.gltf");
        Files.writeString(file, """
                {"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"scale":[0.1,0.1,0.1]},
                {"mesh":0,"translation":[-0.01,0,0],"scale":[-0.1,0.1,0.2],"rotation":[0.1,0,0,0.995]}],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2}]}],
                "buffers":[{"byteLength":92,"uri":"data:application/octet-stream;base64,%s"}],
                "bufferViews":[{"buffer":0,"byteLength":92}],"accessors":[
                {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                {"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC2"},
                {"bufferView":0,"byteOffset":80,"componentType":5123,"count":6,"type":"SCALAR"}]}
                """.replace("%s", data));
        Path joined = folder.resolve("joined.glb");
        try (OutputStream stream = Files.newOutputStream(joined)) {
            MeshWriters.glb(stream, MeshSource.of(file.toString()).load().mesh(), Optional.empty());
        }
        SceneObject shared = object(file.toString(), "blaze", MIXED, Placement.NONE);
        SceneObject whole = object(joined.toString(), "blaze", MIXED, Placement.NONE);
        List<SceneShape.Thing> things = loader().shape(scene(shared)).things();

        assertThat(things).hasSize(2).extracting(SceneShape.Thing::object).containsOnly(0);
        assertThat(things.get(1).mesh()).isSameAs(things.get(0).mesh());
        assertEqual(scene(shared), scene(whole), 1e-3f);
        // The visible sky is sampled at vertices, which a mirrored part has in another order.
        Choices around = around(Optional.of(new SceneColor(0x808080)), 0.3, true);
        assertEqual(scene(shared).with(around), scene(whole).with(around), 0.03f);
    }

    private void assertEqual(Scene actual, Scene expected, float tolerance) {
        float[] wanted = drawn(expected);
        float[] drawn = drawn(actual);
        assertThat(wanted).contains(1f);
        for (int i = 0; i < drawn.length; i++) {
            assertThat(drawn[i]).isCloseTo(wanted[i], within(tolerance * (1 + wanted[i])));
        }
    }

    @Test
    void objectsNearAndFarAreDrawnInOnePicture() {
        SceneObject near = object("sphere", "lamellar", MIXED, at(0, 0, 0, 0.1));
        SceneObject far = object("plane", "blaze", MIXED, at(0, 0, -1e6, 1e6));
        float[] alone = drawn(scene(near));
        float[] behind = drawn(scene(far));
        for (Scene both : List.of(scene(near, far), scene(far, near))) {
            float[] drawn = drawn(both);
            for (int i = 0; i < drawn.length; i++) {
                float expected = alone[i / 4 * 4 + 3] > 0 ? alone[i] : behind[i];
                // Sums of light and body are rounded on the processor or on the graphics card.
                assertThat(drawn[i]).isCloseTo(expected, within(2e-6f + 1e-5f * expected));
            }
        }
        for (float[] one : List.of(alone, behind)) {
            assertThat(IntStream.range(0, WIDTH * HEIGHT).filter(i -> one[4 * i + 3] > 0))
                    .hasSizeGreaterThan(20);
        }
    }

    @Test
    void aSizeBeyondSinglePrecisionIsRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("huge.obj"), "v 0 0 0\nv 9e8 0 0\nv 0 9e8 0\nf 1 2 3\n");
        Scene scene = scene(object(file.toString(), "blaze", MIXED, at(0, 0, 0, 1e-9)));

        assertThatThrownBy(() -> loader().shape(scene))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("1e12 times");
    }

    @Test
    void aChangeOfOneObjectReloadsThatAlone() {
        Scene scene = scene(left, right);
        List<SceneData> before = parts(scene);
        Scene changed = scene.at(1).with(SceneSettings.MESH, "disc").at(0);
        List<SceneData> after = loader().parts(changed, before, share -> {});

        assertThat(after.get(0).shape().things().get(0))
                .isEqualTo(before.get(0).shape().things().get(0));
        assertThat(after.get(0).shape().things().get(1).mesh())
                .isNotSameAs(before.get(0).shape().things().get(1).mesh());
        assertThat(after.get(1).method()).isSameAs(before.get(1).method());
        assertThat(SceneSharing.sharesParts(scene, changed)).isFalse();
        assertThat(SceneSharing.sharesParts(scene, scene.at(1))).isTrue();
        Scene moved =
                SceneSharing.withPartsOf(scene, changed).withLight(scene.light().pointing(new Vector3f(1, 0, 1)));
        assertThat(SceneSharing.sharesParts(moved, scene))
                .as("what is loaded, under the newest light")
                .isTrue();
    }
}
