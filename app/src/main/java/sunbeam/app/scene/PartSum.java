package sunbeam.app.scene;

import java.util.List;
import jrtr.Tile;

/**
 * A scene as the sum of its skin's parts of diffracted light, over the body as shaders/include/blend.glsl has it. Each pixel
 * is blended when all its light is known: how much of the body is seen through depends on the sum.
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
        int columns = samples * width;
        int rows = samples * height;
        for (SceneSession session : sessions) {
            session.update(scene);
            session.prepare(columns, rows, SceneSession.tiles(columns, rows, 1), samples);
        }
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
        Tile fine = new Tile(samples * tile.x(), samples * tile.y(), samples * tile.width(), samples * tile.height());
        return draw(scene, samples * width, samples * height, fine);
    }

    /**
     * Draws a part of a picture as {@link SceneSession#draw(int, int, Tile)}.
     *
     * @param scene that was prepared
     */
    ScenePicture draw(Scene scene, int width, int height, Tile tile) {
        if (sessions.size() == 1) {
            return sessions.get(0).draw(width, height, tile);
        }
        Scene diffracted = scene.withBlend(scene.blend().withoutBody());
        ScenePicture light = ScenePicture.empty(tile.width(), tile.height());
        sessions.forEach(session -> add(drawn(session, diffracted, width, height, tile), light));
        if (!scene.blend().hasBody()) {
            return light;
        }
        Blend body = scene.blend().withDiffraction(0);
        ScenePicture bare = drawn(sessions.get(0), scene.withBlend(body), width, height, tile);
        return over(bare, light, scene.light().intensity());
    }

    private static ScenePicture drawn(SceneSession session, Scene scene, int width, int height, Tile tile) {
        session.update(scene);
        return session.draw(width, height, tile);
    }

    /** Light adds up; what the mesh covers is the same. */
    private static void add(ScenePicture part, ScenePicture sum) {
        for (int i = 0; i < sum.rgba().length; i++) {
            sum.rgba()[i] = i % 4 == 3 ? part.rgba()[i] : sum.rgba()[i] + part.rgba()[i];
        }
    }

    private static ScenePicture over(ScenePicture body, ScenePicture light, double intensity) {
        float[] rgba = light.rgba().clone();
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            double alpha = intensity > 0 ? Math.min(1, rgba[pixel + 1] / intensity) : 0;
            for (int c = 0; c < 3; c++) {
                rgba[pixel + c] += (float) ((1 - alpha) * body.rgba()[pixel + c]);
            }
        }
        return new ScenePicture(light.width(), light.height(), rgba);
    }
}
