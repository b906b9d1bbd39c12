package sunbeam.app.render;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.environment.LightTree;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.text.Text;

/**
 * Number of lights that stand for a scene's environment: doubled until a small picture agrees with that of twice as many.
 *
 * @param other number of lights of the picture beside it
 * @param difference mean CIEDE2000 of both
 * @param median median relative difference of their X, Y, Z
 * @param tolerance the scene's
 */
public record LightCount(int lights, int other, double difference, double median, double tolerance) {
    private static final int FEWEST = 64;

    // Mean CIEDE2000 and median per tolerance: at the tolerance of scenes the 1 and 2 % that certificates allow.
    private static final double DIFFERENCE_PER_TOLERANCE = 100;
    private static final double MEDIAN_PER_TOLERANCE = 2;

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
        double tolerance = scene.method().get(TOLERANCE);
        double exposure = sum.exposure(scene, columns, rows, TimedTiles.large(), () -> false)
                .orElseThrow();
        int lights = FEWEST;
        float[] fewer = drawn(sum, scene, lights, columns, rows);
        while (!interrupted.getAsBoolean()) {
            float[] more = drawn(sum, scene, 2 * lights, columns, rows);
            LightCount count = compared(lights, fewer, more, exposure, tolerance);
            lights *= 2;
            if (!count.isMissed()) {
                return Optional.of(count);
            }
            if (lights == LightTree.MOST) {
                return Optional.of(new LightCount(lights, lights / 2, count.difference(), count.median(), tolerance));
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

    private static LightCount compared(int lights, float[] fewer, float[] more, double exposure, double tolerance) {
        List<Comparison> pixels = IntStream.range(0, more.length / 4)
                .filter(i -> more[4 * i + 3] > 0)
                .mapToObj(i -> new Comparison(xyz(fewer, i), xyz(more, i), 1))
                .toList();
        double difference = pixels.stream()
                .mapToDouble(pixel -> pixel.colorDifference(exposure))
                .average()
                .orElse(0);
        ErrorStatistics relative = Comparison.relative(pixels);
        double median = relative.count() > 0 ? relative.median() : 0;
        return new LightCount(lights, 2 * lights, difference, median, tolerance);
    }

    private static double[] xyz(float[] rgba, int pixel) {
        return new double[] {rgba[4 * pixel], rgba[4 * pixel + 1], rgba[4 * pixel + 2]};
    }

    /** Returns a scene under the most regions of its environment, by which certificates judge pictures under fewer. */
    public static Scene finest(Scene scene) {
        return scene.with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(LightTree.FINEST));
    }

    public Scene in(Scene scene) {
        return scene.with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights));
    }

    public boolean isMissed() {
        return difference > DIFFERENCE_PER_TOLERANCE * tolerance || median > MEDIAN_PER_TOLERANCE * tolerance;
    }

    /** Such as "environment as 256 lights, CIEDE2000 0.4 in the mean and 1.3 % in the median beside 512". */
    public String describe() {
        return Text.format(
                "environment as %d lights, CIEDE2000 %.2g in the mean and %.2g %% in the median beside %d",
                lights, difference, 100 * median, other);
    }

    /** Returns a warning of lights that miss the limits. */
    public String complaint() {
        return Text.format(
                "the environment's lights agree to a mean CIEDE2000 of %.2g and %.2g %% in the median, not to %.2g and %.2g %%"
                        + " as the tolerance asks; smooth small lights of the map, or give roughness",
                difference, 100 * median, DIFFERENCE_PER_TOLERANCE * tolerance, 100 * MEDIAN_PER_TOLERANCE * tolerance);
    }
}
