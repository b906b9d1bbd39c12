package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import jrtr.GraphicsException;
import jrtr.RenderContext;
import jrtr.Tile;
import jrtr.gl.RenderContexts;
import jrtr.scene.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.Environment;

/** What is kept of a picture's geometry is never out of date. */
@NeedsDisplay
class GeometryBuffersTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;

    @TempDir
    private Path folder;

    private RenderContext context;
    private boolean drawsFail;

    @BeforeEach
    void open() {
        RenderContext real = RenderContexts.offscreen();
        context = (RenderContext) Proxy.newProxyInstance(
                RenderContext.class.getClassLoader(),
                new Class<?>[] {RenderContext.class},
                (proxy, method, arguments) -> {
                    if (drawsFail && method.getName().equals("draw")) {
                        throw new GraphicsException("out of triangles");
                    }
                    try {
                        return method.invoke(real, arguments);
                    } catch (InvocationTargetException failure) {
                        throw failure.getCause();
                    }
                });
    }

    @AfterEach
    void close() {
        context.close();
    }

    private float[] fresh(SceneData data, int width, int height) {
        try (SceneSession session = new SceneSession(context, data)) {
            return session.draw(width, height).rgba();
        }
    }

    @Test
    void everyChangeIsSeenAsInAFreshSession() {
        SceneLoader loader = new SceneLoader(new Environment(Map.of(), folder), warning -> {});
        Scene plane = PlaneScenes.blaze().withBlend(new Blend(30, 0.6, 0.7, 0.2));
        List<Scene> changes = List.of(
                plane.withOrientation(new Quaternionf().rotationX(0.4f)),
                plane.withRotatePatch(0.5),
                plane.withView(new Viewpoint(
                        new Camera(new Vector3f(0, -0.1f, 0.3f), new Vector3f(), new Vector3f(0, 1, 0)), 0.5)),
                plane.withLight(new SceneLight(new Vector3f(0.3f, 0.1f, 0.9f), 1)),
                plane.withTexture("elaphe"),
                plane.withMesh("sphere"),
                plane);
        SceneData data = loader.load(plane);
        try (SceneSession session = new SceneSession(context, data)) {
            session.draw(WIDTH, HEIGHT);
            for (Scene change : changes) {
                data = loader.load(change, data);
                session.update(data);
                assertThat(session.draw(WIDTH, HEIGHT).rgba()).isEqualTo(fresh(data, WIDTH, HEIGHT));
                assertThat(session.draw(40, 30).rgba()).isEqualTo(fresh(data, 40, 30));
            }
        }
    }

    @Test
    void moreBlocksThanAreKeptMakeTheSamePicture() {
        // Six blocks of 1024 x 1024, of which four are kept; to and fro between the first and the last.
        int width = 3000;
        int height = 1100;
        SceneData data = PlaneScenes.load(PlaneScenes.blaze(), folder);
        List<Tile> tiles = List.of(
                new Tile(1000, 500, 40, 8),
                new Tile(2040, 1020, 20, 8),
                new Tile(0, 1020, 9, 9),
                new Tile(2500, 3, 9, 9));
        try (SceneSession session = new SceneSession(context, data)) {
            List<float[]> first = tiles.stream()
                    .map(tile -> session.draw(width, height, tile).rgba())
                    .toList();
            for (int i = 0; i < tiles.size(); i++) {
                assertThat(session.draw(width, height, tiles.get(i)).rgba()).isEqualTo(first.get(i));
            }
        }
    }
}
