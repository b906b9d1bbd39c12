package sunbeam.app.render;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.environment.LightTree;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.text.Text;

/**
 * Number of lights that stand for a scene's environment: doubled until a small picture agrees with that of twice as many.
 *
 * @param other number of lights of the picture beside it
 * @param difference mean CIEDE2000 of both
 */
public record LightCount(int lights, int other, double difference, double limit) {
    private static final int FEWEST = 64;

    // Mean CIEDE2000 per tolerance: at the tolerance of scenes the 1 that certificates allow.
    private static final double DIFFERENCE_PER_TOLERANCE = 100;

    /** Longer side, in pixels, of the pictures that are compared. */
    private static final int SIDE = 96;

    /**
     * Empty for a scene without environment, with a number of its own, or by a method that draws the environment's pixels, and if
     * interrupted.
     */
    public static Optional<LightCount> of(
            PartSum sum, Scene scene, int width, int height, BooleanSupplier interrupted) {
        boolean isOpen = scene.hasEnvironment()
                && scene.method().isTable()
                && scene.get(SceneSettings.ENVIRONMENT_LIGHTS).isEmpty();
        if (!isOpen) {
            return Optional.empty();
        }
        double scale = Math.min(1, SIDE / (double) Math.max(width, height));
        int columns = (int) Math.max(1, Math.round(scale * width));
        int rows = (int) Math.max(1, Math.round(scale * height));
        double limit = DIFFERENCE_PER_TOLERANCE * scene.method().get(TOLERANCE);
        double exposure = sum.exposure(scene, columns, rows, TimedTiles.large(), () -> false)
                .orElseThrow();
        int lights = FEWEST;
        float[] fewer = drawn(sum, scene, lights, columns, rows);
        while (!interrupted.getAsBoolean()) {
            float[] more = drawn(sum, scene, 2 * lights, columns, rows);
            double difference = difference(fewer, more, exposure);
            if (difference <= limit) {
                return Optional.of(new LightCount(lights, 2 * lights, difference, limit));
            }
            lights *= 2;
            if (lights == LightTree.MOST) {
                return Optional.of(new LightCount(lights, lights / 2, difference, limit));
            }
            fewer = more;
        }
        return Optional.empty();
    }

    private static float[] drawn(PartSum sum, Scene scene, int lights, int width, int height) {
        Scene with = scene.with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights));
        ScenePicture picture = ScenePicture.empty(width, height);
        for (DrawRequest part : SceneSession.parts(with, width, height, PixelSamples.uniform(PartSum.TABLE_SAMPLES))) {
            ScenePicture drawn = sum.draw(part).reduced(PartSum.TABLE_SAMPLES);
            picture.put(
                    drawn, part.tile().x() / PartSum.TABLE_SAMPLES, part.tile().y() / PartSum.TABLE_SAMPLES);
        }
        return picture.rgba();
    }

    private static double difference(float[] fewer, float[] more, double exposure) {
        return IntStream.range(0, more.length / 4)
                .filter(i -> more[4 * i + 3] > 0)
                .mapToDouble(i -> new Comparison(xyz(fewer, i), xyz(more, i), 1).colorDifference(exposure))
                .average()
                .orElse(0);
    }

    private static double[] xyz(float[] rgba, int pixel) {
        return new double[] {rgba[4 * pixel], rgba[4 * pixel + 1], rgba[4 * pixel + 2]};
    }

    public Scene in(Scene scene) {
        return scene.with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights));
    }

    public boolean isMissed() {
        return difference > limit;
    }

    /** Such as "environment as 256 lights, CIEDE2000 0.4 in the mean beside 512". */
    public String describe() {
        return Text.format("environment as %d lights, CIEDE2000 %.2g in the mean beside %d", lights, difference, other);
    }
}
