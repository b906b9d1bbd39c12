package sunbeam.app.gpu;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.glsl.ShaderLibrary;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;

@NeedsDisplay
public abstract class InAContext {
    protected static RenderContext context;

    @BeforeAll
    static void open() {
        context = RenderContext.offscreen();
    }

    /** Draws with a fragment shader, which may include the program's own, and returns RGBA, row 0 on top. */
    protected static float[] drawn(
            String shader, int width, int height, Map<String, Texture> textures, Consumer<ShaderProgram> setUp) {
        ShaderLibrary library = name -> name.equals("test.frag") ? Optional.of(shader) : Optional.empty();
        try (ShaderProgram program = context.createFullScreenProgram(
                        library.orElse(Shaders.library()).load("test.frag"));
                FloatTarget target = context.createFloatTarget("test", FloatTarget.Spec.color(width, height))) {
            setUp.accept(program);
            context.drawFullScreen(program, textures, target, Tile.whole(width, height));
            return target.read(0);
        }
    }

    @AfterAll
    static void close() {
        context.close();
    }
}
