package sunbeam.app.gpu;

import jrtr.glsl.ShaderLibrary;

/** Library of Sunbeam's shader files and, under {@code jrtr/}, the engine's. */
public final class Shaders {
    private Shaders() {}

    public static ShaderLibrary library() {
        return ShaderLibrary.ofClassPath(Shaders.class.getClassLoader(), "sunbeam/shaders")
                .orElse(ShaderLibrary.ofEngine());
    }
}
