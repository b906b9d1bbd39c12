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
    private final boolean costly;
    private final UniformValues uniforms = new UniformValues();
    private List<Binding> textures;

    /**
     * A costly material without uniform values.
     *
     * @param program from {@link jrtr.RenderContext#createMeshProgram}
     * @param textures by sampler name
     */
    public Material(ShaderProgram program, List<Binding> textures) {
        this(program, textures, true);
    }

    private Material(ShaderProgram program, List<Binding> textures, boolean costly) {
        this.program = Objects.requireNonNull(program, "program");
        this.textures = List.copyOf(textures);
        this.costly = costly;
    }

    /** A material whose shader takes less time than another pass over the triangles; without uniform values. */
    public static Material cheap(ShaderProgram program, List<Binding> textures) {
        return new Material(program, textures, false);
    }

    /**
     * Whether a shape's depth is drawn first, so that the shader runs once per pixel. An application may instead draw what
     * its costly shader needs by a cheap material, and run that shader afterwards.
     */
    public boolean isCostly() {
        return costly;
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
