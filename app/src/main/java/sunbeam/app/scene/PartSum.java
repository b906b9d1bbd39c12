package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.IntStream;
import jrtr.Tile;

/**
 * A scene as the sum of its skin's parts of diffracted light, of each patch and of an index by wavelength, over the body
 * as shaders/include/blend.glsl has it. Each pixel is blended when all its light is known: how much of the body is seen through depends on the sum.
 */
public final class PartSum {
    private final List<SceneSession> sessions;

    /** @param sessions of each part; of one for a scene that is a whole */
    public PartSum(List<SceneSession> sessions) {
        this.sessions = List.copyOf(sessions);
    }

    /**
     * Goes over to a scene as {@link SceneSession#update(Scene)}, and makes what its parts' pictures look into.
     *
     * @param width pixels per row of the picture
     * @param height rows
     * @param samples along a pixel's side
     */
    public void prepare(Scene scene, int width, int height, int samples) {
        prepare(scene, width, height, SceneSession.tiles(width, height, samples), samples);
    }

    /** As {@link #prepare(Scene, int, int, int)}, for some tiles of the picture, in pixels. */
    public void prepare(Scene scene, int width, int height, List<Tile> tiles, int samples) {
        List<Tile> fine = tiles.stream().map(tile -> scaled(tile, samples)).toList();
        for (SceneSession session : sessions) {
            session.update(scene);
            session.prepare(samples * width, samples * height, fine, samples);
        }
    }

    private static Tile scaled(Tile tile, int samples) {
        return new Tile(samples * tile.x(), samples * tile.y(), samples * tile.width(), samples * tile.height());
    }

    /** As {@link SceneSession#pick}, of the scene that was prepared or drawn last. */
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return sessions.isEmpty() ? Optional.empty() : sessions.get(0).pick(x, y, width, height);
    }

    /**
     * Draws the samples of a part of a picture.
     *
     * @param width pixels per row of the whole picture
     * @param height rows of the whole picture
     * @param tile in pixels
     * @param samples along a pixel's side
     * @return {@code samples x samples} for each pixel of the tile
     */
    public ScenePicture samples(Scene scene, int width, int height, Tile tile, int samples) {
        sessions.forEach(session -> session.drawSamples(samples));
        return draw(scene, samples * width, samples * height, scaled(tile, samples));
    }

    /** As {@link SceneSession#draw(int, int, Tile)}, of a scene that was prepared. */
    ScenePicture draw(Scene scene, int width, int height, Tile tile) {
        if (sessions.size() == 1) {
            sessions.get(0).update(scene);
            return sessions.get(0).draw(width, height, tile);
        }
        return ScenePicture.sum(IntStream.range(0, scene.lights())
                .mapToObj(light -> underOneLight(scene.underLight(light), width, height, tile))
                .toList());
    }

    private ScenePicture underOneLight(Scene scene, int width, int height, Tile tile) {
        ScenePicture light = light(scene, tile.width(), tile.height(), session -> session.draw(width, height, tile));
        return scene.blend().hasBody() ? over(body(scene, width, height, tile), light, scene) : light;
    }

    /**
     * Draws the scene by few samples of its diffracted light, over its whole body.
     *
     * @param stride each stride-th pixel of each stride-th row has a sample; a power of two
     * @param white luminance above which a sample is dimmed, lest a glint fill all that is between it and its neighbors
     * @param tiles in which samples are drawn
     * @param interrupted asked before each tile
     * @return nothing where it was interrupted
     */
    public Optional<ScenePicture> coarse(
            Scene scene,
            int width,
            int height,
            int stride,
            double white,
            TimedTiles tiles,
            BooleanSupplier interrupted) {
        sessions.forEach(session -> session.drawSamples(1));
        List<ScenePicture> lit = new ArrayList<>();
        for (int light = 0; light < scene.lights(); light++) {
            coarseUnderOneLight(scene.underLight(light), width, height, stride, white, tiles, interrupted)
                    .ifPresent(lit::add);
            if (lit.size() == light) {
                return Optional.empty();
            }
        }
        return Optional.of(ScenePicture.sum(lit));
    }

    private Optional<ScenePicture> coarseUnderOneLight(
            Scene scene,
            int width,
            int height,
            int stride,
            double white,
            TimedTiles tiles,
            BooleanSupplier interrupted) {
        int columns = SceneSession.few(width, stride);
        int rows = SceneSession.few(height, stride);
        ScenePicture light = ScenePicture.empty(columns, rows);
        boolean isWhole = tiles.draw(Tile.cover(columns, rows, TimedTiles.LARGEST), interrupted, few -> {
            int x = stride * few.x();
            int y = stride * few.y();
            Tile tile = new Tile(
                    x, y, Math.min(stride * few.width(), width - x), Math.min(stride * few.height(), height - y));
            light.put(
                    light(scene, few.width(), few.height(), session -> session.draw(width, height, tile, stride)),
                    few.x(),
                    few.y());
        });
        if (!isWhole) {
            return Optional.empty();
        }
        ScenePicture body = body(scene, width, height, Tile.whole(width, height));
        return Optional.of(over(body, light.enlarged(stride, body, white), scene));
    }

    private ScenePicture light(Scene scene, int columns, int rows, Function<SceneSession, ScenePicture> drawing) {
        Scene diffracted = scene.withBlend(scene.blend().withoutBody());
        ScenePicture light = ScenePicture.empty(columns, rows);
        for (SceneSession session : sessions) {
            session.update(diffracted);
            add(drawing.apply(session), light);
        }
        return light;
    }

    private ScenePicture body(Scene scene, int width, int height, Tile tile) {
        SceneSession session = sessions.get(0);
        session.update(scene.with(SceneSettings.DIFFRACTION, 0.0));
        return session.draw(width, height, tile);
    }

    /** Light adds up, as far as there is any; what the mesh covers is the same. */
    private static void add(ScenePicture part, ScenePicture sum) {
        for (int i = 0; i < sum.rgba().length; i++) {
            sum.rgba()[i] = i % 4 == 3 ? Math.abs(part.rgba()[i]) : sum.rgba()[i] + part.rgba()[i];
        }
    }

    private static ScenePicture over(ScenePicture body, ScenePicture light, Scene scene) {
        double intensity = scene.light().intensity();
        // Fresnel's reflectance has hidden the body when it was drawn.
        boolean byLight = scene.bodyAlpha() == BodyAlpha.LIGHT;
        double share = byLight ? 1 : 1 - scene.blend().ambient();
        float[] rgba = light.rgba().clone();
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            double alpha = byLight && intensity > 0 ? Math.min(1, rgba[pixel + 1] / intensity) : 0;
            for (int c = 0; c < 3; c++) {
                rgba[pixel + c] = (float) (share * rgba[pixel + c] + (1 - alpha) * body.rgba()[pixel + c]);
            }
            rgba[pixel + 3] = body.rgba()[pixel + 3];
        }
        return new ScenePicture(light.width(), light.height(), rgba);
    }
}
