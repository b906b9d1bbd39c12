package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import jrtr.Tile;
import sunbeam.app.scene.Scene;
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

    /**
     * An animation.
     *
     * @param session draws it
     * @param scenes of its frames, at least two, which the session can go over to
     */
    public record Frames(SceneSession session, List<Scene> scenes) {
        public Frames {
            scenes = List.copyOf(scenes);
        }

        private SceneSession at(int frame) {
            session.update(scenes.get(frame));
            return session;
        }
    }

    /** A pixel and the mean of its points. */
    private record Exact(Tile pixel, double[] xyz) {}

    /** A pixel that the mesh fills in two frames, and its means there. */
    private record Pair(Tile pixel, double[] before, double[] after) {}

    /**
     * Draws random pixels both ways.
     *
     * @param exposure factor for X, Y, Z before colors are compared
     * @param drawn the scene as it is to be judged
     * @param exact the same scene by a method that draws points
     * @param samples of the mesh along a pixel's side in what is judged
     * @param count pixels, if there are so many that the mesh fills
     * @param seed the same seed draws the same pixels
     */
    public SceneCertificate certify(
            SceneSession drawn, SceneSession exact, int samples, double exposure, int count, long seed) {
        List<Exact> means = means(exact, count, new SplittableRandom(seed));
        List<double[]> pixels =
                drawn(drawn, samples, means.stream().map(Exact::pixel).toList());
        List<double[]> diffracted =
                withoutBody(drawn, samples, means.stream().map(Exact::pixel).toList());
        List<Comparison> compared = new ArrayList<>();
        List<Comparison> diffracting = new ArrayList<>();
        for (int i = 0; i < means.size(); i++) {
            Comparison pixel = comparison(pixels.get(i), means.get(i).xyz());
            compared.add(pixel);
            if (diffracted.get(i)[1] > SceneCertificate.DIFFRACTING * pixels.get(i)[1]) {
                diffracting.add(pixel);
            }
        }
        return SceneCertificate.of(compared, exposure, diffracting);
    }

    private List<double[]> withoutBody(SceneSession session, int samples, List<Tile> pixels) {
        Scene scene = session.scene();
        try {
            session.update(scene.withBlend(scene.blend().withoutBody()));
            return drawn(session, samples, pixels);
        } finally {
            session.update(scene);
        }
    }

    /**
     * Draws random pixels of an animation both ways, each in a frame and in the next one.
     *
     * @param drawn the animation as it is to be judged
     * @param exact the same frames by a method that draws points
     * @param count pixels, if there are so many that the mesh fills in both frames
     * @see #certify(SceneSession, SceneSession, int, double, int, long)
     */
    public CrawlCertificate certify(Frames drawn, Frames exact, int samples, double exposure, int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int steps = drawn.scenes().size() - 1;
        List<CrawlCertificate.Change> changes = new ArrayList<>();
        for (int step = 0; step < steps; step++) {
            int share = (int) ((step + 1L) * count / steps - (long) step * count / steps);
            List<Pair> pairs = pairs(exact, step, share, random);
            List<Tile> pixels = pairs.stream().map(Pair::pixel).toList();
            List<double[]> before = drawn(drawn.at(step), samples, pixels);
            List<double[]> after = drawn(drawn.at(step + 1), samples, pixels);
            for (int i = 0; i < pairs.size(); i++) {
                changes.add(new CrawlCertificate.Change(
                        comparison(before.get(i), pairs.get(i).before()),
                        comparison(after.get(i), pairs.get(i).after())));
            }
        }
        return CrawlCertificate.of(changes, exposure);
    }

    /** White is 1; there is no darker thing to compare with than a mesh in the dark. */
    private static Comparison comparison(double[] drawn, double[] mean) {
        return new Comparison(drawn, mean, 1);
    }

    private List<double[]> drawn(SceneSession session, int samples, List<Tile> pixels) {
        List<Tile> sampled =
                pixels.stream().map(pixel -> scaled(pixel, samples)).toList();
        session.prepare(samples * width, samples * height, sampled, samples);
        return sampled.stream()
                .map(pixel -> xyz(
                        session.draw(samples * width, samples * height, pixel).reduced(samples)))
                .toList();
    }

    private List<Exact> means(SceneSession exact, int count, SplittableRandom random) {
        List<Exact> means = new ArrayList<>();
        for (int i = 0; i < MOST_TRIES * count && means.size() < count; i++) {
            Tile pixel = new Tile(random.nextInt(width), random.nextInt(height), 1, 1);
            mean(exact, pixel).ifPresent(xyz -> means.add(new Exact(pixel, xyz)));
        }
        return means;
    }

    /** Of pixels that are filled in one frame some are not in the next. */
    private List<Pair> pairs(Frames exact, int step, int count, SplittableRandom random) {
        List<Exact> before = means(exact.at(step), count, random);
        SceneSession next = exact.at(step + 1);
        List<Pair> pairs = new ArrayList<>();
        for (Exact first : before) {
            mean(next, first.pixel()).ifPresent(xyz -> pairs.add(new Pair(first.pixel(), first.xyz(), xyz)));
        }
        return pairs;
    }

    /** The mean of a pixel's points; nothing where the mesh does not fill it. */
    private Optional<double[]> mean(SceneSession exact, Tile pixel) {
        if (exact.pick(pixel.x(), pixel.y(), width, height).isEmpty()) {
            return Optional.empty();
        }
        ScenePicture mean = exact.draw(POINTS * width, POINTS * height, scaled(pixel, POINTS))
                .reduced(POINTS);
        return mean.rgba()[3] > 1 - 0.5f / (POINTS * POINTS) ? Optional.of(xyz(mean)) : Optional.empty();
    }

    private static Tile scaled(Tile pixel, int samples) {
        return new Tile(samples * pixel.x(), samples * pixel.y(), samples, samples);
    }

    private static double[] xyz(ScenePicture pixel) {
        return new double[] {pixel.rgba()[0], pixel.rgba()[1], pixel.rgba()[2]};
    }
}
