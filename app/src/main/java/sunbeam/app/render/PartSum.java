package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import jrtr.Tile;
import sunbeam.app.scene.BodyAlpha;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;

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
     * Makes the tiles that a picture reads.
     *
     * @param width pixels per row of the picture
     * @param height rows
     * @param samples along a pixel's side
     */
    public void prepare(Scene scene, int width, int height, int samples) {
        prepare(SceneSession.parts(scene, width, height, samples));
    }

    /** Makes the tiles that some parts of one picture read. */
    public void prepare(List<DrawRequest> parts) {
        sessions.forEach(session -> session.prepare(parts));
    }

    /** As {@link SceneSession#pick}. */
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return sessions.isEmpty() ? Optional.empty() : sessions.get(0).pick(x, y, width, height);
    }

    /** As {@link SceneSession#draw}. */
    public ScenePicture draw(DrawRequest request) {
        if (sessions.size() == 1) {
            return sessions.get(0).draw(request);
        }
        return ScenePicture.sum(
                request.perLight().stream().map(this::underOneLight).toList());
    }

    private ScenePicture underOneLight(DrawRequest request) {
        ScenePicture light = light(request, SceneSession::draw);
        return request.scene().blend().hasBody() ? over(body(request), light, request.scene()) : light;
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
            DrawRequest request = new DrawRequest(scene, width, height, tile, 1, stride);
            light.put(light(request, SceneSession::drawResident), few.x(), few.y());
        });
        if (!isWhole) {
            return Optional.empty();
        }
        ScenePicture body = body(new DrawRequest(scene, width, height, Tile.whole(width, height), 1, 1));
        return Optional.of(over(body, light.enlarged(stride, body, white), scene));
    }

    private ScenePicture light(DrawRequest request, BiFunction<SceneSession, DrawRequest, ScenePicture> drawing) {
        Scene scene = request.scene();
        DrawRequest diffracted = request.with(scene.withBlend(scene.blend().withoutBody()));
        ScenePicture light = ScenePicture.empty(request.columns(), request.rows());
        sessions.forEach(session -> add(drawing.apply(session, diffracted), light));
        return light;
    }

    private ScenePicture body(DrawRequest request) {
        return sessions.get(0).draw(request.with(request.scene().with(SceneSettings.DIFFRACTION, 0.0)));
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
