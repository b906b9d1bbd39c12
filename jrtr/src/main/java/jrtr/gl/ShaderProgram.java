package jrtr.gl;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.util.glsl.ShaderUtil;
import java.util.Map;
import jrtr.GraphicsException;
import jrtr.ShaderSource;
import org.joml.Matrix3fc;
import org.joml.Matrix4fc;
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
        int fragmentShader = 0;
        try {
            fragmentShader = compile(gl, fragment, GL3.GL_FRAGMENT_SHADER);
            name = link(gl, vertexShader, fragmentShader, vertex, fragment);
        } finally {
            gl.glDeleteShader(vertexShader);
            // OpenGL ignores 0.
            gl.glDeleteShader(fragmentShader);
        }
        GlUniforms found = new GlUniforms(gl, name, label(), vertex.text() + fragment.text());
        device().check(gl, "linking " + label());
        return found;
    }

    private static int compile(GL3 gl, ShaderSource source, int stage) {
        int shader = gl.glCreateShader(stage);
        gl.glShaderSource(shader, 1, new String[] {source.text()}, null);
        gl.glCompileShader(shader);
        if (ShaderUtil.isShaderStatusValid(gl, shader, GL3.GL_COMPILE_STATUS, null)) {
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
        if (ShaderUtil.isProgramStatusValid(gl, program, GL3.GL_LINK_STATUS)) {
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

    /**
     * Sets a {@code float}, a vector, a matrix column by column, or the first elements of an array. Elements past the array's end are
     * ignored. Throws {@link IllegalArgumentException} if the number of values is 0 or does not fit the uniform's type.
     */
    public void set(String uniform, float... values) {
        GL3 gl = gl();
        gl.glUseProgram(name);
        uniforms.set(gl, uniform, values);
    }

    /** Sets an {@code int}, a vector or an array of integers as {@link #set(String, float...)} does. */
    public void set(String uniform, int... values) {
        GL3 gl = gl();
        gl.glUseProgram(name);
        uniforms.set(gl, uniform, values);
    }

    public void set(String uniform, Vector3fc value) {
        set(uniform, value.x(), value.y(), value.z());
    }

    public void set(String uniform, Matrix3fc value) {
        set(uniform, value.get(new float[9]));
    }

    public void set(String uniform, Matrix4fc value) {
        set(uniform, value.get(new float[16]));
    }

    public boolean isActive(String uniform) {
        return uniforms.isActive(uniform);
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteProgram(name);
    }
}
