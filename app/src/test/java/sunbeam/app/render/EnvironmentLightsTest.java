package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.precompute.method.Methods.METHOD;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import jrtr.Tile;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Weights;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** Few lights stand for an environment. */
class EnvironmentLightsTest extends InAScene {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 7;

    private static Scene underWindow() {
        return blaze().withMethod(new SceneMethod(Choices.none().with(METHOD, TableMethod.TYPE)))
                .with(Weights.of(4000, 1, 0.1, 0))
                .with(SceneSettings.ROUGHNESS, Math.toRadians(3))
                .with(SceneSettings.ENVIRONMENT, "window");
    }

    private static Scene under(int lights) {
        return underWindow().with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights));
    }

    /** Each pixel has one sample, so that nothing but the lights differs. */
    private static double medianError(PartSum sum, Scene scene, ScenePicture finest) {
        float[] drawn = drawn(sum, scene).rgba();
        List<Comparison> pixels = new ArrayList<>();
        for (int i = 0; i < drawn.length; i += 4) {
            if (drawn[i + 3] == 1) {
                pixels.add(new Comparison(xyz(drawn, i), xyz(finest.rgba(), i), 1));
            }
        }
        assertThat(pixels).hasSizeGreaterThan(WIDTH * HEIGHT / 5);
        return Comparison.relative(pixels).median();
    }

    private static double[] xyz(float[] rgba, int at) {
        return new double[] {rgba[at], rgba[at + 1], rgba[at + 2]};
    }

    private static ScenePicture drawn(PartSum sum, Scene scene) {
        return sum.draw(DrawRequest.ofPixels(scene, WIDTH, HEIGHT, Tile.whole(WIDTH, HEIGHT), 1));
    }

    @Test
    void asManyLightsAreDrawnAsTheToleranceNeeds() {
        try (SceneSession session = session(underWindow())) {
            PartSum sum = new PartSum(List.of(session));
            LightCount count = LightCount.of(sum, underWindow(), WIDTH, HEIGHT, () -> false)
                    .orElseThrow();
            assertThat(count.isMissed()).as(count.describe()).isFalse();
            ScenePicture finest = drawn(sum, LightCount.finest(underWindow()));
            // N and 2 N lights differ by at most 2 % in the median; errors that are independent of those of 2 N lights
            // are smaller.
            assertThat(medianError(sum, count.in(underWindow()), finest)).isLessThan(0.02);
            // The comparison sees lights that are too few.
            assertThat(medianError(sum, under(8), finest)).isGreaterThan(0.05);
        }
    }

    /** Samples of a body have different lights, so that they differ everywhere, but only edges of geometry need more samples. */
    @Test
    void onlyEdgesAreRefined() {
        Scene scene = under(256).with(Weights.of(0, 1, 1, 0));
        PixelSamples samples = new PixelSamples(4, List.of(4));
        Tile whole = Tile.whole(WIDTH, HEIGHT);
        try (SceneSession session = session(scene)) {
            PartSum sum = new PartSum(List.of(session));
            float[] refined =
                    sum.draw(scene, WIDTH, HEIGHT, whole, samples, 1).light().rgba();
            var first = new PixelPicture(WIDTH, HEIGHT, scene.display(1), scene.background());
            first.setAll(sum.draw(DrawRequest.first(scene, WIDTH, HEIGHT, whole, samples)), 1, 4);
            float[] unrefined = first.light().rgba();
            int[] changed = IntStream.range(0, WIDTH * HEIGHT)
                    .filter(i -> !Arrays.equals(refined, 4 * i, 4 * i + 4, unrefined, 4 * i, 4 * i + 4))
                    .toArray();
            assertThat(changed).isNotEmpty();
            for (int pixel : changed) {
                assertThat(isAtEdge(refined, pixel)).as("pixel %d", pixel).isTrue();
            }
        }
    }

    /** True if the plane fills the pixel's neighborhood only in part. */
    private static boolean isAtEdge(float[] rgba, int pixel) {
        int x = pixel % WIDTH;
        int y = pixel / WIDTH;
        boolean isFilled = x > 0 && x < WIDTH - 1 && y > 0 && y < HEIGHT - 1;
        for (int row = y - 1; isFilled && row <= y + 1; row++) {
            for (int column = x - 1; column <= x + 1; column++) {
                isFilled &= rgba[4 * (row * WIDTH + column) + 3] == 1;
            }
        }
        return !isFilled;
    }
}
