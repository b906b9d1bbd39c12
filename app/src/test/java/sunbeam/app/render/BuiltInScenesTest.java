package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.scene.View;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.MeshChecks;
import sunbeam.app.terminal.Environment;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.setting.Choices;

/** Built-in scenes: their colors, what they frame, and the wireframe that a first preview shows. */
class BuiltInScenesTest extends InAScene {
    @Test
    @Tag("thorough")
    void allAreDrawnInColorsAndMeteredAsTheyAreFirstShown() throws IOException {
        assertDrawnInColors(Scenes.builtIn());
        assertMeteredAsFirstShown(Scenes.builtIn());
    }

    @Test
    void theSnakeIsDrawnInColors() throws IOException {
        assertDrawnInColors(List.of("elaphe"));
    }

    @Test
    void theOpeningSceneIsMeteredAsItIsFirstShown() {
        assertMeteredAsFirstShown(List.of("close-up"));
    }

    /** Before the viewer has colors it shows white under the light as white: an exposure of one over the light's intensity. */
    private void assertMeteredAsFirstShown(List<String> names) {
        for (String name : names) {
            Scene scene = Scenes.load(name);
            try (SceneSession session = session(scene)) {
                double exposure = new PartSum(List.of(session))
                        .exposure(scene, 640, 480, TimedTiles.large(), () -> false)
                        .orElseThrow();
                // A tenth of a stop, which is hardly visible.
                assertThat(Math.log(exposure * scene.light().intensity()) / Math.log(2))
                        .as(name)
                        .isBetween(-0.1, 0.1);
            }
        }
        // The coarsest level is too coarse for this picture, which says nothing about the table.
        assertThat(warnings).noneMatch(line -> line.contains("table of colors errs"));
    }

    @Test
    void theExposureUnderALightIsAtMostAFactorOfTwoOffThatUnderItsNeighbors() {
        double[] neighbors = {4, 0.9, 0.5, 1.6};
        double middle = Math.sqrt(0.9 * 1.6);
        assertThat(PartSum.bounded(0.05, neighbors)).as("a glare").isCloseTo(middle / 2, within(1e-12));
        assertThat(PartSum.bounded(20, neighbors)).as("darkness").isCloseTo(middle * 2, within(1e-12));
        assertThat(PartSum.bounded(0.7, neighbors)).as("as composed").isEqualTo(0.7);
    }

    private void assertDrawnInColors(List<String> names) throws IOException {
        // No cache: tables of gigabytes would be written and read again.
        Path noFolder = Files.createFile(folder.resolve("file"));
        Map<String, String> variables = Map.of("XDG_CACHE_HOME", noFolder.toString());
        SceneLoader loader = new SceneLoader(new Environment(variables, folder), warning -> {});
        // One patch after the other: its scenes share its tables.
        List<Scene> scenes = names.stream()
                .map(Scenes::load)
                .map(BuiltInScenesTest::byFull)
                .sorted(Comparator.comparing((Scene scene) -> scene.patch().toString()))
                .toList();
        List<SceneData> parts = loader.parts(scenes.get(0), BackgroundTask.start(() -> loader.shape(scenes.get(0))));
        for (Scene scene : scenes) {
            parts = loader.parts(scene, parts, share -> {});
            List<SceneSession> sessions = SceneSession.all(context, parts);
            try {
                DrawRequest whole = DrawRequest.ofPixels(scene, 24, 18, Tile.whole(24, 18), 1);
                float[] pixels = new PartSum(sessions).draw(whole).rgba();
                assertThat(isColored(pixels)).as(scene.get(SceneSettings.TITLE)).isTrue();
            } finally {
                sessions.forEach(SceneSession::close);
            }
        }
    }

    /** Tables for nine scenes would take minutes, and the occlusion of the sky two seconds for each. */
    private static Scene byFull(Scene scene) {
        return scene.with(Choices.none().with(METHOD, FullMethod.TYPE).with(TOLERANCE, 0.02))
                .with(around(Optional.empty(), 0, false));
    }

    private static boolean isColored(float[] pixels) {
        for (int i = 0; i < pixels.length; i += 4) {
            float sum = pixels[i] + pixels[i + 1] + pixels[i + 2];
            // White has x = 0.313 and z = 0.358.
            if (sum > 0 && (Math.abs(pixels[i] / sum - 0.313) > 0.03 || Math.abs(pixels[i + 2] / sum - 0.358) > 0.03)) {
                return true;
            }
        }
        return false;
    }

    private static final Mesh SNAKE = BuiltInMeshes.create("snake");

    @ParameterizedTest
    @CsvSource({"800, 600", "870, 811", "600, 600", "300, 1200", "2000, 500", "16, 9000"})
    void theWholeSnakeIsInThePicture(int width, int height) {
        for (String name : new String[] {"elaphe", "xenopeltis"}) {
            float[] reach = reach(Scenes.load(name), width, height);
            assertThat(reach[0]).as("%s, left and right", name).isLessThan(1);
            assertThat(reach[1]).as("%s, bottom and top", name).isLessThan(1);
            // The snake spans at least half of one side.
            assertThat(Math.max(reach[0], reach[1])).as("%s, larger", name).isGreaterThan(0.5f);
        }
    }

    /** Greatest distance of the mesh from the middle along x and y, in halves of the picture. */
    private static float[] reach(Scene scene, int width, int height) {
        Matrix4f toClip = new SkinGeometry(List.of(), scene.view(), width, height)
                .sight()
                .worldToClip(View.Area.whole(width, height));
        float[] reach = new float[2];
        for (int vertex = 0; vertex < SNAKE.vertices(); vertex++) {
            Vector3f point = toClip.transformProject(new Vector3f(MeshChecks.position(SNAKE, vertex)));
            reach[0] = Math.max(reach[0], Math.abs(point.x));
            reach[1] = Math.max(reach[1], Math.abs(point.y));
        }
        return reach;
    }

    private static final int SIDE = 200;

    /** Strokes along a sphere's normals, 3 % of its radius long, make its outline wider by 3 %. */
    @Test
    void normalsPointOutwards() {
        Scene scene = Scenes.load("elaphe").with(Choices.none().with(SceneSettings.MESH, "sphere"));

        double ratio = width(scene, true) / width(scene, false);

        // Two pixels of 200, and the perspective enlarges nearer parts.
        assertThat(ratio).isCloseTo(1.03, within(0.012));
    }

    private static double width(Scene scene, boolean normals) {
        BufferedImage image = LineDrawings.wireframe(scene, scene.mesh().load().mesh(), normals, SIDE, SIDE);
        int[] columns = IntStream.range(0, SIDE)
                .filter(x -> IntStream.range(0, SIDE).anyMatch(y -> image.getRGB(x, y) != image.getRGB(0, 0)))
                .toArray();
        return columns[columns.length - 1] - columns[0];
    }
}
