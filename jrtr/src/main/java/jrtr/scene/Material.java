package jrtr.scene;

import java.util.List;
import java.util.Objects;
import jrtr.Binding;
import jrtr.ShaderProgram;

/**
 * How a shape looks: a program, values for its uniforms, textures for its samplers. Several materials may share a
 * program. Owns neither program nor textures. The engine's own uniforms (mesh.vert.glsl, jrtr/surface.glsl) are set by
 * {@link SceneRenderer}; all others, {@code tangentRotation} among them, are the material's.
 */
public final class Material {
    private final ShaderProgram program;
    private final UniformValues uniforms = new UniformValues();
    private List<Binding> textures;

    /**
     * A material without uniform values.
     *
     * @param program from {@link jrtr.RenderContext#createMeshProgram}
     * @param textures by sampler name
     */
    public Material(ShaderProgram program, List<Binding> textures) {
        this.program = Objects.requireNonNull(program, "program");
        this.textures = List.copyOf(textures);
    }

    /** The shader. */
    public ShaderProgram program() {
        return program;
    }

    /** The values, to be set and changed; each draw sets them all. */
    public UniformValues uniforms() {
        return uniforms;
    }

    /** Textures by sampler name. */
    public List<Binding> textures() {
        return textures;
    }

    /** Takes other textures. */
    public void setTextures(List<Binding> value) {
        textures = List.copyOf(value);
    }
}
