package sunbeam.app.gpu;

import jrtr.glsl.ShaderLibrary;

/** The shader files that come with Sunbeam. */
public final class Shaders {
    private Shaders() {}

    public static ShaderLibrary library() {
        return ShaderLibrary.ofClassPath(Shaders.class.getClassLoader(), "sunbeam/shaders");
    }
}
