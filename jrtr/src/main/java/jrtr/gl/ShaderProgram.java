package jrtr.gl;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.util.glsl.ShaderUtil;
import java.util.Map;
import java.util.function.BiConsumer;
import jrtr.GraphicsException;
import jrtr.ShaderSource;
import org.joml.Matrix3fc;
import org.joml.Matrix4fc;
import org.joml.Vector2fc;
import org.joml.Vector3fc;

/**
 * A linked pair of a vertex and a fragment shader with its uniforms, which keep their values until they are set again. A setter ignores a
 * uniform that the shaders declare but that the compiler optimized away, or that an {@code #if} excludes. Any other unknown name, and a
 * value of the wrong type, is a {@link GraphicsException} that lists the uniforms. Textures are bound to samplers per draw. Matrices
 * multiply column vectors from the left, {@code M * v}, as in GLSL and JOML.
 */
public final class ShaderProgram extends Resource {
    // 0 until it is linked.
    private int name;
    private final GlUniforms uniforms;

    ShaderProgram(GlDevice device, ShaderSource vertex, ShaderSource fragment) {
        super(device, vertex.name() + " + " + fragment.name());
        uniforms = orClose(() -> build(gl(), vertex, fragment), this::close);
    }

    private GlUniforms build(GL3 gl, ShaderSource vertex, ShaderSource fragment) {
        int vertexShader = compile(gl, vertex, GL3.GL_VERTEX_SHADER);
        try {
            int fragmentShader = compile(gl, fragment, GL3.GL_FRAGMENT_SHADER);
            try {
                name = link(gl, vertexShader, fragmentShader, vertex, fragment);
            } finally {
                gl.glDeleteShader(fragmentShader);
            }
        } finally {
            gl.glDeleteShader(vertexShader);
        }
        GlUniforms found = new GlUniforms(gl, name, label(), vertex.text() + fragment.text());
        device().check(gl, "linking " + label());
        return found;
    }

    private static int compile(GL3 gl, ShaderSource source, int stage) {
        int shader = gl.glCreateShader(stage);
        gl.glShaderSource(shader, 1, new String[] {source.text()}, null);
        gl.glCompileShader(shader);
        int[] status = new int[1];
        gl.glGetShaderiv(shader, GL3.GL_COMPILE_STATUS, status, 0);
        if (status[0] == GL3.GL_TRUE) {
            return shader;
        }
        String log = ShaderUtil.getShaderInfoLog(gl, shader);
        gl.glDeleteShader(shader);
        throw source.failure("compiling " + source.name(), log);
    }

    private static int link(GL3 gl, int vertexShader, int fragmentShader, ShaderSource vertex, ShaderSource fragment) {
        int program = gl.glCreateProgram();
        gl.glAttachShader(program, vertexShader);
        gl.glAttachShader(program, fragmentShader);
        gl.glLinkProgram(program);
        gl.glDetachShader(program, vertexShader);
        gl.glDetachShader(program, fragmentShader);
        int[] status = new int[1];
        gl.glGetProgramiv(program, GL3.GL_LINK_STATUS, status, 0);
        if (status[0] == GL3.GL_TRUE) {
            return program;
        }
        String log = ShaderUtil.getProgramInfoLog(gl, program);
        gl.glDeleteProgram(program);
        throw fragment.failure("linking " + vertex.name() + " with " + fragment.name(), log);
    }

    void use(GL3 gl, Map<String, Texture> textures, FloatTarget target) {
        uniforms.bind(gl, device(), textures, target);
        gl.glUseProgram(name);
    }

    /** @param value GLSL's name of the types, for messages */
    private void set(String uniform, String value, BiConsumer<GL3, GlUniforms.Uniform> setter, int... types) {
        GL3 gl = gl();
        gl.glUseProgram(name);
        GlUniforms.Uniform found = uniforms.findOfType(uniform, value, types);
        if (found != null) {
            setter.accept(gl, found);
        }
    }

    private void set(String uniform, String value, float[] values, int... types) {
        BiConsumer<GL3, GlUniforms.Uniform> setter = (gl, found) -> {
            int location = found.location();
            switch (found.type()) {
                case GL3.GL_FLOAT_MAT3 -> gl.glUniformMatrix3fv(location, 1, false, values, 0);
                case GL3.GL_FLOAT_MAT4 -> gl.glUniformMatrix4fv(location, 1, false, values, 0);
                case GL3.GL_FLOAT -> gl.glUniform1fv(location, elements(found, values.length), values, 0);
                case GL3.GL_FLOAT_VEC2 -> gl.glUniform2fv(location, elements(found, values.length), values, 0);
                case GL3.GL_FLOAT_VEC3 -> gl.glUniform3fv(location, elements(found, values.length), values, 0);
                default -> gl.glUniform4fv(location, elements(found, values.length), values, 0);
            }
        };
        set(uniform, value, setter, types);
    }

    public void set(String uniform, float value) {
        set(uniform, "float", new float[] {value}, GL3.GL_FLOAT);
    }

    public void set(String uniform, int value) {
        set(uniform, "int", (gl, found) -> gl.glUniform1i(found.location(), value), GL3.GL_INT);
    }

    public void set(String uniform, Vector2fc value) {
        set(uniform, "vec2", new float[] {value.x(), value.y()}, GL3.GL_FLOAT_VEC2);
    }

    public void set(String uniform, Vector3fc value) {
        set(uniform, "vec3", new float[] {value.x(), value.y(), value.z()}, GL3.GL_FLOAT_VEC3);
    }

    public void set(String uniform, Matrix3fc value) {
        set(uniform, "mat3", value.get(new float[9]), GL3.GL_FLOAT_MAT3);
    }

    public void set(String uniform, Matrix4fc value) {
        set(uniform, "mat4", value.get(new float[16]), GL3.GL_FLOAT_MAT4);
    }

    /**
     * Sets the first elements of an array of {@code float}s or vectors, or one vector. Elements past the array's end are ignored. Throws
     * {@link IllegalArgumentException} if the number of values is 0 or does not fit the uniform's type.
     */
    public void set(String uniform, float[] values) {
        set(uniform, "float[]", values, GL3.GL_FLOAT, GL3.GL_FLOAT_VEC2, GL3.GL_FLOAT_VEC3, GL3.GL_FLOAT_VEC4);
    }

    /** Sets a uniform of integers, or an array of them. */
    public void set(String uniform, int[] values) {
        BiConsumer<GL3, GlUniforms.Uniform> setter = (gl, found) -> {
            int count = elements(found, values.length);
            switch (found.components()) {
                case 1 -> gl.glUniform1iv(found.location(), count, values, 0);
                case 2 -> gl.glUniform2iv(found.location(), count, values, 0);
                case 3 -> gl.glUniform3iv(found.location(), count, values, 0);
                default -> gl.glUniform4iv(found.location(), count, values, 0);
            }
        };
        set(uniform, "int[]", setter, GL3.GL_INT, GL3.GL_INT_VEC2, GL3.GL_INT_VEC3, GL3.GL_INT_VEC4);
    }

    private int elements(GlUniforms.Uniform uniform, int values) {
        int components = uniform.components();
        if (values == 0 || values % components != 0 || (!uniform.array() && values != components)) {
            throw new IllegalArgumentException(
                    label() + ": " + values + " values for uniform " + uniform.describe() + " do not fit");
        }
        return values / components;
    }

    public boolean isActive(String uniform) {
        return uniforms.isActive(uniform);
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteProgram(name);
    }
}
