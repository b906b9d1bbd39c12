package jrtr.scene;

import java.util.Map;
import jrtr.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;

/**
 * Material of a shape: a program, textures for its samplers, values for its uniforms. Several materials may share a
 * program. Owns neither program nor textures. The engine's own uniforms (mesh.vert.glsl, jrtr/surface.glsl) are set by
 * {@link SceneRenderer}; the material sets all others, for example those of {@link #tangentsTurned}.
 *
 * @param program from {@link jrtr.gl.RenderContext#createMeshProgram}
 * @param textures by sampler name
 * @param uniforms {@code float}s by name
 */
public record Material(ShaderProgram program, Map<String, Texture> textures, Map<String, Float> uniforms, Faces faces) {
    public Material {
        textures = Map.copyOf(textures);
        uniforms = Map.copyOf(uniforms);
    }

    /**
     * Returns the uniforms of jrtr/tangent_frame.glsl.
     *
     * @param radians rotation of the frame about the normal, counter-clockwise seen from outside
     */
    public static Map<String, Float> tangentsTurned(double radians) {
        return Map.of("tangentCosine", (float) Math.cos(radians), "tangentSine", (float) Math.sin(radians));
    }
}
