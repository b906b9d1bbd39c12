package jrtr.gl;

import java.util.Map;
import java.util.Optional;
import jrtr.ShaderSource;
import jrtr.Tile;
import jrtr.glsl.ShaderLibrary;

public final class Rendering implements AutoCloseable {
    public final RenderContext context = RenderContext.offscreen();

    public static ShaderLibrary library(Map<String, String> files) {
        return name -> Optional.ofNullable(files.get(name));
    }

    static ShaderSource fragment(String code) {
        return library(Map.of("test.frag.glsl", "#version 330 core\n" + code)).load("test.frag.glsl");
    }

    /** A program whose main() is {@code color = vec4(...)}. */
    public ShaderProgram program(String declarations, String color) {
        return context.createFullScreenProgram(
                fragment(declarations + "\nout vec4 color;\nvoid main() { color = " + color + "; }\n"));
    }

    /** A program for meshes that may include the engine's shaders. */
    public ShaderProgram meshProgram(String code) {
        return context.createMeshProgram(library(Map.of("test.frag", "#version 330 core\n" + code))
                .orElse(ShaderLibrary.ofEngine())
                .load("test.frag"));
    }

    FloatTarget target(int width, int height) {
        return context.createFloatTarget("test target", FloatTarget.Spec.color(width, height));
    }

    void draw(ShaderProgram program, FloatTarget target, Map<String, Texture> textures) {
        Tile whole = Tile.whole(target.spec().width(), target.spec().height());
        context.drawFullScreen(program, textures, target, whole);
    }

    /** Draws and reads back RGBA, row 0 on top. */
    float[] drawn(ShaderProgram program, int width, int height, Map<String, Texture> textures) {
        try (FloatTarget target = target(width, height)) {
            draw(program, target, textures);
            return target.read(0);
        }
    }

    @Override
    public void close() {
        context.close();
    }
}
