package jrtr.glsl;

import java.util.Optional;

/** The shader files that come with the engine; their names begin with {@code jrtr/}. */
public final class EngineShaders {
    private static final String PREFIX = "jrtr/";

    private EngineShaders() {}

    /**
     * Returns the engine's files; an application appends them to its own with {@link ShaderLibrary#orElse}. Fragment shaders of meshes may
     * include {@code jrtr/surface.glsl} and {@code jrtr/tangent_frame.glsl}.
     */
    public static ShaderLibrary library() {
        ShaderLibrary files = ShaderLibrary.ofClassPath(EngineShaders.class.getClassLoader(), "jrtr/shaders");
        return name -> name.startsWith(PREFIX) ? files.text(name.substring(PREFIX.length())) : Optional.empty();
    }
}
