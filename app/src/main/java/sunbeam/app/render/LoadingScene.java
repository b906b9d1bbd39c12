package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import sunbeam.app.render.SceneLoader.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.work.BackgroundTask;

/** Loads a scene in the background while OpenGL starts, and uploads its shape and parts as they are loaded. */
public final class LoadingScene implements AutoCloseable {
    private final Scene scene;
    private final BackgroundTask<SceneShape> shape;
    private final BackgroundTask<List<SceneData>> parts;

    private LoadingScene(SceneLoader loader, Scene scene) {
        this.scene = scene;
        this.shape = BackgroundTask.start(() -> loader.shape(scene));
        this.parts = BackgroundTask.start(() -> loader.parts(scene, shape));
    }

    public static LoadingScene start(SceneLoader loader, Scene scene) {
        return new LoadingScene(loader, scene);
    }

    /** Creates a context for the upload. A failure of loading is reported first, since the user can fix it. */
    public RenderContext offscreen() {
        try {
            return RenderContext.offscreen();
        } catch (GraphicsException failure) {
            parts.get();
            throw failure;
        }
    }

    /** Uploads each part as a session, which the caller closes. Throws {@link GraphicsException} if the device has no room. */
    public List<SceneSession> upload(RenderContext context) {
        List<SceneSession> sessions = new ArrayList<>();
        try {
            sessions.add(new SceneSession(context, scene, shape.get()));
            List<SceneData> loaded = parts.get();
            sessions.get(0).update(loaded.get(0));
            loaded.stream().skip(1).forEach(part -> sessions.add(new SceneSession(context, part)));
            return List.copyOf(sessions);
        } catch (RuntimeException | OutOfMemoryError failure) {
            sessions.forEach(SceneSession::close);
            throw failure;
        }
    }

    @Override
    public void close() {
        parts.settle();
    }
}
