package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import jrtr.Tile;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;

/**
 * Compares pixels of a scene with the mean of many points in each: what a picture would show that was drawn with so many
 * samples. Only pixels that the mesh fills are compared; how well a picture draws edges is a matter of its samples.
 */
public final class SceneCertifier {
    /** Points along a pixel's side; 256 in all. */
    public static final int POINTS = 16;

    // Of a scene that shows little of its mesh.
    private static final int MOST_TRIES = 200;

    private final int width;
    private final int height;

    /**
     * @param width of the picture, pixels
     * @param height of it
     */
    public SceneCertifier(int width, int height) {
        this.width = width;
        this.height = height;
    }

    /** A pixel and its mean. */
    private record Exact(Tile pixel, double[] xyz) {}

    /**
     * Draws random pixels both ways.
     *
     * @param exposure factor for X, Y, Z before colours are compared
     * @param drawn the scene as it is to be judged
     * @param exact the same scene by a method that draws points
     * @param samples of the mesh along a pixel's side in what is judged
     * @param count pixels, if there are so many that the mesh fills
     * @param seed the same seed draws the same pixels
     */
    public SceneCertificate certify(
            SceneSession drawn, SceneSession exact, int samples, double exposure, int count, long seed) {
        List<Exact> means = means(exact, count, seed);
        List<Tile> pixels =
                means.stream().map(mean -> scaled(mean.pixel(), samples)).toList();
        drawn.prepare(samples * width, samples * height, pixels, samples);
        List<Comparison> compared = new ArrayList<>();
        for (int i = 0; i < means.size(); i++) {
            ScenePicture pixel = drawn.draw(samples * width, samples * height, pixels.get(i));
            // White is 1; there is no darker thing to compare with than a mesh in the dark.
            compared.add(
                    new Comparison(xyz(pixel.reduced(samples)), means.get(i).xyz(), 1));
        }
        return SceneCertificate.of(compared, exposure);
    }

    private List<Exact> means(SceneSession exact, int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Exact> means = new ArrayList<>();
        for (int i = 0; i < MOST_TRIES * count && means.size() < count; i++) {
            Tile pixel = new Tile(random.nextInt(width), random.nextInt(height), 1, 1);
            if (exact.pick(pixel.x(), pixel.y(), width, height).isPresent()) {
                ScenePicture points = exact.draw(POINTS * width, POINTS * height, scaled(pixel, POINTS));
                ScenePicture mean = points.reduced(POINTS);
                if (mean.rgba()[3] > 1 - 0.5f / (POINTS * POINTS)) {
                    means.add(new Exact(pixel, xyz(mean)));
                }
            }
        }
        return means;
    }

    private static Tile scaled(Tile pixel, int samples) {
        return new Tile(samples * pixel.x(), samples * pixel.y(), samples, samples);
    }

    private static double[] xyz(ScenePicture pixel) {
        return new double[] {pixel.rgba()[0], pixel.rgba()[1], pixel.rgba()[2]};
    }
}
