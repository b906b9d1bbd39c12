package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import jrtr.ContextInfo;
import jrtr.RenderContext;
import jrtr.Tile;
import jrtr.gl.RenderContexts;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.ScenePreview;
import sunbeam.app.scene.SceneSession;
import sunbeam.precompute.optics.Direction;

/** Everything of the viewer that lives on the graphics card. Belongs to the thread that made it. */
final class GraphicsStage implements AutoCloseable {
    private final RenderContext context;
    private final SceneDisplay display;
    private final MapStage map;
    private SceneSession fine;
    private SceneSession coarse;

    /** Opens a context without a window. */
    GraphicsStage() {
        context = RenderContexts.offscreen();
        display = new SceneDisplay(context);
        map = new MapStage(context);
    }

    ContextInfo info() {
        return context.info();
    }

    /** Goes over to a state; if that fails, the old one stays. */
    void update(ViewState state) {
        if (fine == null) {
            SceneSession first = new SceneSession(context, state.fine());
            try {
                coarse = new SceneSession(context, state.coarse());
                fine = first;
            } finally {
                if (fine == null) {
                    first.close();
                }
            }
            return;
        }
        var before = fine.data();
        fine.update(state.fine());
        try {
            coarse.update(state.coarse());
        } catch (RuntimeException failure) {
            fine.update(before);
            throw failure;
        }
    }

    ScenePreview preview(int width, int height, int divisor) {
        return coarse.preview(width, height, divisor);
    }

    ScenePicture part(int width, int height, Tile tile) {
        return fine.draw(width, height, tile);
    }

    /** Time that has gone to the mesh of parts so far. */
    long meshNanoseconds() {
        return fine.meshNanoseconds();
    }

    double exposure(Scene scene, ScenePicture picture) {
        return SceneDisplay.exposure(scene, picture);
    }

    BufferedImage image(Scene scene, ScenePicture picture, double exposure) {
        return display.image(picture, exposure, scene.background());
    }

    Optional<Pick> pick(int x, int y, int width, int height) {
        return fine == null ? Optional.empty() : fine.pick(x, y, width, height);
    }

    /** The BRDF map of the scene's method; null if it was interrupted. */
    BufferedImage map(Direction light, int size, BooleanSupplier interrupted) {
        return map.draw(fine.method(), light, size, interrupted);
    }

    @Override
    public void close() {
        try {
            map.close();
            if (fine != null) {
                fine.close();
                coarse.close();
            }
            display.close();
        } finally {
            context.close();
        }
    }
}
