package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.BrdfMapRenderer;
import sunbeam.app.gpu.BrdfMapRenderer.DiscDirections;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneSession;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.work.CancellationToken;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;

/** Draws the BRDF map beside the picture, a small preview first. */
final class MapStage {
    private static final int PREVIEW_SIZE = 48;
    private static final int SIZE = 192;
    private static final long COARSE_NANOSECONDS = 100_000_000;

    private final RenderContext context;
    private final TimedTiles tiles = new TimedTiles(System::nanoTime);
    private CancellationToken newest = new CancellationToken();
    // Tables and light of the displayed coarse map; null if another map is displayed.
    private List<Object> coarse;
    private long coarseDrawn = System.nanoTime() - COARSE_NANOSECONDS;

    private record Part(SceneData data, VirtualTexture colors) {}

    MapStage(RenderContext context) {
        this.context = context;
    }

    void cancel() {
        newest.cancel();
    }

    void draw(
            UploadedTables method,
            Direction light,
            boolean isFinal,
            BooleanSupplier interrupted,
            BiConsumer<BufferedImage, Boolean> drawn) {
        coarse = null;
        for (int size : isFinal ? new int[] {PREVIEW_SIZE, SIZE} : new int[] {PREVIEW_SIZE}) {
            try (BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size, 0)) {
                List<Tile> blocks = Tile.whole(size, size).divide(TimedTiles.LARGEST);
                if (!tiles.draw(blocks, interrupted, tile -> renderer.draw(light, tile))) {
                    return;
                }
                drawn.accept(shown(renderer.picture()), size == SIZE);
            }
        }
    }

    /** Draws a small map from the finest wholly resident level of color tables, in some milliseconds, at most ten times a second. */
    void drawMoving(List<SceneSession> sessions, Direction light, BiConsumer<BufferedImage, Boolean> drawn) {
        long now = System.nanoTime();
        List<Object> wanted =
                List.of(sessions.stream().map(SceneSession::virtualTexture).toList(), light);
        if (!wanted.equals(coarse) && now - coarseDrawn >= COARSE_NANOSECONDS) {
            coarse = wanted;
            coarseDrawn = now;
            drawn.accept(map(parts(sessions), light, PREVIEW_SIZE, VirtualTexture::coarseColors), false);
        }
    }

    /**
     * Draws a map from the tables at once, if their coarsest level is resident, and queues one that is drawn when the picture's tiles are
     * baked: its colors keep the scene's tolerance, without the tables' averages over a pixel.
     */
    void drawLater(List<SceneSession> sessions, Direction light, BiConsumer<BufferedImage, Boolean> drawn) {
        CancellationToken token = new CancellationToken();
        newest = token;
        coarse = null;
        List<Part> parts = parts(sessions);
        if (parts.stream().allMatch(part -> part.colors.hasCoarsest())) {
            drawn.accept(map(parts, light, SIZE, VirtualTexture::coarseColors), false);
        }
        parts.get(0)
                .colors
                .whenIdle(
                        token,
                        () -> drawn.accept(
                                map(parts, light, SIZE, (colors, points) -> colors.bakePoints(points, token)), true));
    }

    private static List<Part> parts(List<SceneSession> sessions) {
        return sessions.stream()
                .map(session ->
                        new Part(session.data(), session.virtualTexture().orElseThrow()))
                .toList();
    }

    /** @param colors powers by (u, v, w) */
    private static BufferedImage map(
            List<Part> parts, Direction light, int size, BiFunction<VirtualTexture, float[], float[]> colors) {
        DiscDirections directions = new DiscDirections(size, light);
        float[] xyz = new float[3 * size * size];
        Arrays.fill(xyz, Float.NaN);
        int[] covered =
                IntStream.range(0, size * size).filter(directions::covers).toArray();
        float[] points = points(directions, covered);
        for (Part part : parts) {
            add(directions, covered, part.data, colors.apply(part.colors, points), xyz);
        }
        return shown(new LinearPicture(size, size, xyz));
    }

    private static float[] points(DiscDirections directions, int[] pixels) {
        float[] points = new float[3 * pixels.length];
        for (int i = 0; i < pixels.length; i++) {
            DirectionPair pair = directions.at(pixels[i]);
            points[3 * i] = (float) pair.u();
            points[3 * i + 1] = (float) pair.v();
            points[3 * i + 2] = (float) pair.w();
        }
        return points;
    }

    private static void add(DiscDirections directions, int[] pixels, SceneData data, float[] power, float[] xyz) {
        for (int i = 0; i < pixels.length; i++) {
            DirectionPair pair = directions.at(pixels[i]);
            double gain = data.reflectanceComponent()
                    .map(component -> component.reflection().gain(pair))
                    .orElseGet(() -> Gain.relativeRadiance(pair));
            for (int c = 0; c < 3; c++) {
                int at = 3 * pixels[i] + c;
                xyz[at] = (float) (gain * power[3 * i + c] + (Float.isNaN(xyz[at]) ? 0 : xyz[at]));
            }
        }
    }

    private static BufferedImage shown(LinearPicture picture) {
        return picture.shown(new DisplayTransform(LinearPicture.exposure(picture), Tone.COMPRESS));
    }
}
