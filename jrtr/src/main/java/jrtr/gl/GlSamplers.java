package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import jrtr.ShaderException;

/** Samplers of a program. Each has a fixed texture unit, so that a draw only binds textures. */
final class GlSamplers {
    private final String program;
    private final GlUniforms uniforms;
    private final Map<String, Integer> units = new LinkedHashMap<>();
    private final boolean[] boundUnits;

    /** Assigns the units; the program must be current. */
    GlSamplers(GL3 gl, String program, GlUniforms uniforms) {
        this.program = program;
        this.uniforms = uniforms;
        for (GlUniform uniform : uniforms.active().values()) {
            if (uniform.isSampler()) {
                if (uniform.samplerTarget() == 0 || uniform.array()) {
                    throw new ShaderException(program + ": sampler " + uniform.describe()
                            + " is not supported; use sampler2D or sampler2DArray");
                }
                gl.glUniform1i(uniform.location(), units.size());
                units.put(uniform.name(), units.size());
            }
        }
        this.boundUnits = new boolean[units.size()];
    }

    void bind(GL3 gl, GlDevice device, List<Binding> bindings, FloatTarget target) {
        Arrays.fill(boundUnits, false);
        for (Binding binding : bindings) {
            Texture texture = binding.texture();
            texture.requireUsableBy(device);
            texture.requireUploaded();
            if (target.owns(texture)) {
                throw new IllegalStateException(
                        "target '" + target.label() + "' is drawn to and read as a texture in one draw");
            }
            bindOne(gl, binding.sampler(), texture);
        }
        requireAllBound();
    }

    private void bindOne(GL3 gl, String sampler, Texture texture) {
        GlUniform uniform = uniforms.find(sampler);
        if (uniform == null) {
            return;
        }
        if (uniform.samplerTarget() != texture.glTarget) {
            throw new ShaderException(program + ": '" + texture.label() + "' is "
                    + (texture.isArray() ? "an array" : "no array") + " and cannot be bound to "
                    + uniform.describe());
        }
        int unit = units.get(sampler);
        if (boundUnits[unit]) {
            throw new ShaderException(program + ": sampler '" + sampler + "' is bound twice");
        }
        boundUnits[unit] = true;
        gl.glActiveTexture(GL3.GL_TEXTURE0 + unit);
        gl.glBindTexture(texture.glTarget, texture.glName());
    }

    private void requireAllBound() {
        for (Map.Entry<String, Integer> sampler : units.entrySet()) {
            if (!boundUnits[sampler.getValue()]) {
                throw new ShaderException(program + ": no texture is bound to sampler '" + sampler.getKey() + "'");
            }
        }
    }
}
