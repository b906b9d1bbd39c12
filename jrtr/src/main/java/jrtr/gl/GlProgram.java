package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Set;
import java.util.TreeSet;
import jrtr.ShaderProgram;
import jrtr.ShaderSource;
import jrtr.glsl.DeclaredUniforms;
import org.joml.Matrix3fc;
import org.joml.Matrix4fc;
import org.joml.Vector2fc;
import org.joml.Vector3fc;
import org.joml.Vector4fc;

/** A linked program. */
final class GlProgram extends GlResource implements ShaderProgram {
    private final int name;
    private final GlUniforms uniforms;
    private final GlSamplers samplers;
    private final float[] matrix = new float[16];

    private GlProgram(GlDevice device, String label, int name, Set<String> declared) {
        super(device, label);
        this.name = name;
        GL3 gl = device.gl();
        try {
            this.uniforms = new GlUniforms(gl, name, label, declared);
            gl.glUseProgram(name);
            this.samplers = new GlSamplers(gl, label, uniforms);
            device.check(gl, "linking " + label);
        } catch (RuntimeException failure) {
            close();
            throw failure;
        }
    }

    static GlProgram create(GlDevice device, ShaderSource vertex, ShaderSource fragment) {
        int name = new GlCompiler(device).build(vertex, fragment);
        Set<String> declared = new TreeSet<>(DeclaredUniforms.in(vertex));
        declared.addAll(DeclaredUniforms.in(fragment));
        return new GlProgram(device, vertex.name() + " + " + fragment.name(), name, declared);
    }

    /** Makes this the program of the next draws. */
    void use(GL3 gl) {
        gl.glUseProgram(name);
    }

    GlSamplers glSamplers() {
        return samplers;
    }

    /** Makes this program current for a setter. */
    private GL3 current() {
        GL3 gl = gl();
        gl.glUseProgram(name);
        return gl;
    }

    @Override
    public void set(String uniform, float value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "float", GL3.GL_FLOAT);
        if (found != null) {
            gl.glUniform1f(found.location(), value);
        }
    }

    @Override
    public void set(String uniform, int value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "int", GL3.GL_INT);
        if (found != null) {
            gl.glUniform1i(found.location(), value);
        }
    }

    @Override
    public void set(String uniform, Vector2fc value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "vec2", GL3.GL_FLOAT_VEC2);
        if (found != null) {
            gl.glUniform2f(found.location(), value.x(), value.y());
        }
    }

    @Override
    public void set(String uniform, Vector3fc value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "vec3", GL3.GL_FLOAT_VEC3);
        if (found != null) {
            gl.glUniform3f(found.location(), value.x(), value.y(), value.z());
        }
    }

    @Override
    public void set(String uniform, Vector4fc value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "vec4", GL3.GL_FLOAT_VEC4);
        if (found != null) {
            gl.glUniform4f(found.location(), value.x(), value.y(), value.z(), value.w());
        }
    }

    @Override
    public void set(String uniform, Matrix3fc value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "mat3", GL3.GL_FLOAT_MAT3);
        if (found != null) {
            gl.glUniformMatrix3fv(found.location(), 1, false, value.get(matrix), 0);
        }
    }

    @Override
    public void set(String uniform, Matrix4fc value) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(uniform, "mat4", GL3.GL_FLOAT_MAT4);
        if (found != null) {
            gl.glUniformMatrix4fv(found.location(), 1, false, value.get(matrix), 0);
        }
    }

    @Override
    public void set(String uniform, float[] values) {
        GL3 gl = current();
        GlUniform found = uniforms.findOfType(
                uniform, "float[]", GL3.GL_FLOAT, GL3.GL_FLOAT_VEC2, GL3.GL_FLOAT_VEC3, GL3.GL_FLOAT_VEC4);
        if (found == null) {
            return;
        }
        int count = elements(found, values.length);
        switch (found.components()) {
            case 1 -> gl.glUniform1fv(found.location(), count, values, 0);
            case 2 -> gl.glUniform2fv(found.location(), count, values, 0);
            case 3 -> gl.glUniform3fv(found.location(), count, values, 0);
            default -> gl.glUniform4fv(found.location(), count, values, 0);
        }
    }

    @Override
    public void set(String uniform, int[] values) {
        GL3 gl = current();
        GlUniform found =
                uniforms.findOfType(uniform, "int[]", GL3.GL_INT, GL3.GL_INT_VEC2, GL3.GL_INT_VEC3, GL3.GL_INT_VEC4);
        if (found == null) {
            return;
        }
        int count = elements(found, values.length);
        switch (found.components()) {
            case 1 -> gl.glUniform1iv(found.location(), count, values, 0);
            case 2 -> gl.glUniform2iv(found.location(), count, values, 0);
            case 3 -> gl.glUniform3iv(found.location(), count, values, 0);
            default -> gl.glUniform4iv(found.location(), count, values, 0);
        }
    }

    private int elements(GlUniform uniform, int values) {
        int components = uniform.components();
        if (values == 0 || values % components != 0 || (!uniform.array() && values != components)) {
            throw new IllegalArgumentException(
                    label() + ": " + values + " values for uniform " + uniform.describe() + " do not fit");
        }
        return values / components;
    }

    @Override
    public boolean isActive(String uniform) {
        return uniforms.active().containsKey(uniform);
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteProgram(name);
    }
}
