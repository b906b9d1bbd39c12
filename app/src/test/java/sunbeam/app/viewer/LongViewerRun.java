package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.InputEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import sunbeam.app.longrun.Footprint;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.precompute.patch.PatchRequest;

/**
 * A viewer that a robot drives for long: light, model, patch, mesh, scene, map and size, in random order, each until the
 * final picture is there. Not among the tests: {@code ./sunbeam test -Dtest=LongViewerRun -Dsunbeam.minutes=30}; the table
 * and the plot go to {@code app/target/long-run}.
 */
@Timeout(36_000)
final class LongViewerRun extends ViewerInAWindow {
    private static final List<String> PATCHES = List.of("blaze", "sinusoid", "lamellar");
    private static final List<String> MESHES = List.of("cylinder", "sphere", "plane");

    private final Random random = new Random(4);
    private final TreeMap<String, Integer> done = new TreeMap<>();

    @Test
    void memoryResourcesAndFilesDoNotGrowWithTime() throws Exception {
        double minutes = Double.parseDouble(System.getProperty("sunbeam.minutes", "30"));
        long end = System.nanoTime() + Math.round(minutes * 60e9);
        try (Footprint footprint = new Footprint(2000)) {
            while (System.nanoTime() < end) {
                act();
                // A frame that is lost never becomes final, or has another size than the view.
                awaitFinal();
            }
            footprint.write(Path.of("target", "long-run"), "viewer-%.0f-minutes".formatted(minutes));
            System.out.println("done: " + done);
            assertThat(footprint.growth(Footprint.Look::residentMebibytes))
                    .as("growth of memory / MiB")
                    .isLessThan(200);
            // Scenes differ in what they hold, by a few resources.
            assertThat(footprint.growth(Footprint.Look::resources))
                    .as("growth of resources")
                    .isLessThan(10);
            assertThat(footprint.growth(Footprint.Look::files))
                    .as("growth of open files")
                    .isLessThan(10);
        }
    }

    private void act() throws Exception {
        switch (random.nextInt(8)) {
            case 0, 1 -> change("light", scene -> scene.withLight(light()));
            case 2 -> {
                count("drag");
                drag(InputEvent.BUTTON1_DOWN_MASK);
            }
            case 3 -> change("patch", scene -> scene.withPatch(PatchRequest.of(oneOf(PATCHES))));
            case 4 -> change("mesh", scene -> scene.withMesh(oneOf(MESHES)));
            case 5 -> resize();
            case 6 -> {
                count("map or cone");
                onEvents(() -> {
                    if (random.nextBoolean()) {
                        viewer.toggleMap();
                    } else {
                        viewer.toggleCone();
                    }
                    return null;
                });
            }
            default -> {
                count("scene");
                Scene next = scene().withLight(light()).withPatch(PatchRequest.of(oneOf(PATCHES)));
                onEvents(() -> {
                    viewer.model().open(next, () -> {});
                    return null;
                });
            }
        }
    }

    private void change(String what, java.util.function.UnaryOperator<Scene> change) throws Exception {
        count(what);
        onEvents(() -> {
            viewer.model().change(change);
            return null;
        });
    }

    private void resize() throws Exception {
        count("size");
        int width = 450 + random.nextInt(300);
        int height = 300 + random.nextInt(200);
        onEvents(() -> {
            viewer.window().setMinimumSize(null);
            viewer.window().setSize(width, height);
            return null;
        });
    }

    private SceneLight light() {
        return new SceneLight(
                new Vector3f(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, -0.3f - random.nextFloat())
                        .normalize(),
                1);
    }

    private <T> T oneOf(List<T> choices) {
        return choices.get(random.nextInt(choices.size()));
    }

    private void count(String what) {
        done.merge(what, 1, Integer::sum);
    }
}
