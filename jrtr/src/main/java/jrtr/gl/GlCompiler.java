package jrtr.gl;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.util.glsl.ShaderUtil;
import java.util.List;
import jrtr.ShaderException;
import jrtr.ShaderProblem;
import jrtr.ShaderSource;
import jrtr.glsl.CompilerLog;

/** Compiles and links shaders; failures name file and line. */
final class GlCompiler {
    private final GL3 gl;

    GlCompiler(GlDevice device) {
        this.gl = device.gl();
    }

    int build(ShaderSource vertex, ShaderSource fragment) {
        int vertexShader = compile(vertex, GL3.GL_VERTEX_SHADER);
        try {
            int fragmentShader = compile(fragment, GL3.GL_FRAGMENT_SHADER);
            try {
                return link(vertexShader, fragmentShader, vertex, fragment);
            } finally {
                gl.glDeleteShader(fragmentShader);
            }
        } finally {
            gl.glDeleteShader(vertexShader);
        }
    }

    private int compile(ShaderSource source, int stage) {
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
        throw failure("compiling " + source.name(), source, log);
    }

    private int link(int vertexShader, int fragmentShader, ShaderSource vertex, ShaderSource fragment) {
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
        throw failure("linking " + vertex.name() + " with " + fragment.name(), fragment, log);
    }

    private static ShaderException failure(String doing, ShaderSource source, String log) {
        List<ShaderProblem> problems = CompilerLog.parse(log, source);
        return problems.isEmpty()
                ? new ShaderException(source.name() + ": the driver failed without a reason [" + doing + "]")
                : new ShaderException(doing, problems);
    }
}
