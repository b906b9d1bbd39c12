package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.setting.Choices;

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
        SceneLoader loader =
                new SceneLoader(new Environment(Map.of("XDG_CACHE_HOME", folder + ""), folder), warnings::add);
        for (String name : names) {
            Scene scene = Scenes.load(name);
            try (SceneSession session =
                    new SceneSession(context, loader.parts(scene).get(0))) {
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
        SceneData data = loader.parts(scenes.get(0)).get(0);
        try (SceneSession session = new SceneSession(context, data)) {
            for (Scene scene : scenes) {
                data = loader.parts(scene, List.of(data), share -> {}).get(0);
                session.update(data);
                float[] pixels = picture(session, 24, 18).rgba();
                assertThat(isColored(pixels)).as(scene.get(SceneSettings.TITLE)).isTrue();
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
}
