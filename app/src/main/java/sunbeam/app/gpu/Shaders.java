package sunbeam.app.gpu;

import jrtr.glsl.EngineShaders;
import jrtr.glsl.ShaderLibrary;

/** The shader files that come with Sunbeam, and behind them the engine's, whose names begin with {@code jrtr/}. */
public final class Shaders {
    private Shaders() {}

    public static ShaderLibrary library() {
        return ShaderLibrary.ofClassPath(Shaders.class.getClassLoader(), "sunbeam/shaders")
                .orElse(EngineShaders.library());
    }
}
