package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import jrtr.Tile;
import sunbeam.app.render.DrawRequest;
import sunbeam.app.render.PartSum;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.ScenePicture;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.text.Text;

/**
 * Compares pixels of a scene's picture with the mean of many points in each. Only pixels that the mesh fills are compared, since at edges
 * the error depends only on the number of samples.
 */
public record SceneCertifier(int width, int height, PixelSamples samples) {
    /** Points along a pixel's side; 256 in all. */
    public static final int POINTS = 16;

    // Most random pixels tried per compared pixel: the mesh may fill few of them.
    private static final int MOST_TRIES = 200;

    private record Exact(Tile pixel, double[] xyz) {}

    /**
     * Draws random pixels, fewer than {@code count} if the mesh fills fewer, by the method to be judged and by points.
     *
     * @param drawn renderer to be judged, of {@code scene}
     * @param exact renderer of the same scene as {@code points}
     * @param exposure factor for X, Y, Z before colors are compared
     */
    public Certificate certify(PartSum drawn, Scene scene, PartSum exact, Scene points, double exposure, int count) {
        List<Exact> means = means(exact, points, count, new SplittableRandom(Certificate.SEED));
        List<double[]> pixels =
                drawn(drawn, scene, exposure, means.stream().map(Exact::pixel).toList());
        // The gain is 1, that of white: Comparison's floor for dark pixels needs no other scale.
        List<Comparison> compared = IntStream.range(0, means.size())
                .mapToObj(i -> new Comparison(pixels.get(i), means.get(i).xyz(), 1))
                .toList();
        String places = Text.format(
                "%d random pixels that the mesh fills, beside the mean of %d points in each",
                means.size(), POINTS * POINTS);
        return Certificate.ofPixels(places, compared, exposure, Certificate.Limits.ANTI_ALIASED);
    }

    private List<double[]> drawn(PartSum parts, Scene scene, double exposure, List<Tile> pixels) {
        List<DrawRequest> requests = pixels.stream()
                .map(pixel -> DrawRequest.ofPixels(scene, width, height, pixel, samples))
                .toList();
        return requests.stream()
                .map(request -> parts.draw(request, exposure).reduced(samples.side()))
                .map(picture -> Comparison.xyz(picture.rgba(), 0))
                .toList();
    }

    private List<Exact> means(PartSum exact, Scene scene, int count, SplittableRandom random) {
        List<Exact> means = new ArrayList<>();
        for (int i = 0; i < MOST_TRIES * count && means.size() < count; i++) {
            Tile pixel = new Tile(random.nextInt(width), random.nextInt(height), 1, 1);
            mean(exact, scene, pixel).ifPresent(xyz -> means.add(new Exact(pixel, xyz)));
        }
        return means;
    }

    /** Returns the mean of a pixel's points; empty if the mesh does not fill the pixel. */
    private Optional<double[]> mean(PartSum exact, Scene scene, Tile pixel) {
        if (exact.pick(pixel.x(), pixel.y(), width, height).isEmpty()) {
            return Optional.empty();
        }
        ScenePicture mean = exact.draw(DrawRequest.ofPixels(scene, width, height, pixel, PixelSamples.uniform(POINTS)))
                .reduced(POINTS);
        return mean.rgba()[3] > 1 - 0.5f / (POINTS * POINTS)
                ? Optional.of(Comparison.xyz(mean.rgba(), 0))
                : Optional.empty();
    }
}
