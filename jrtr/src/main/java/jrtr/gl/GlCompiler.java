package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.List;
import jrtr.ShaderException;
import jrtr.ShaderProblem;
import jrtr.ShaderSource;
import jrtr.glsl.CompilerLog;

/** Compiles and links, and says what went wrong where. */
final class GlCompiler {
    private static final System.Logger LOGGER = System.getLogger("jrtr.gl");

    private final GlDevice device;
    private final GL3 gl;

    GlCompiler(GlDevice device) {
        this.device = device;
        this.gl = device.gl();
    }

    /** The linked program's name in OpenGL. */
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
        String log = shaderLog(shader);
        if (status[0] == GL3.GL_TRUE) {
            logWarnings(source, log);
            return shader;
        }
        gl.glDeleteShader(shader);
        device.forgetMessages();
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
        String log = programLog(program);
        if (status[0] == GL3.GL_TRUE) {
            logWarnings(fragment, log);
            return program;
        }
        gl.glDeleteProgram(program);
        device.forgetMessages();
        throw failure("linking " + vertex.name() + " with " + fragment.name(), fragment, log);
    }

    private static ShaderException failure(String doing, ShaderSource source, String log) {
        List<ShaderProblem> problems = CompilerLog.parse(log, source);
        return problems.isEmpty()
                ? new ShaderException(source.name() + ": the driver failed without a reason [" + doing + "]")
                : new ShaderException(doing, problems);
    }

    private static void logWarnings(ShaderSource source, String log) {
        for (ShaderProblem problem : CompilerLog.parse(log, source)) {
            LOGGER.log(Level.DEBUG, problem::describe);
        }
    }

    private String shaderLog(int shader) {
        int[] length = new int[1];
        gl.glGetShaderiv(shader, GL3.GL_INFO_LOG_LENGTH, length, 0);
        byte[] log = new byte[Math.max(1, length[0])];
        gl.glGetShaderInfoLog(shader, log.length, length, 0, log, 0);
        return new String(log, 0, length[0], StandardCharsets.UTF_8);
    }

    private String programLog(int program) {
        int[] length = new int[1];
        gl.glGetProgramiv(program, GL3.GL_INFO_LOG_LENGTH, length, 0);
        byte[] log = new byte[Math.max(1, length[0])];
        gl.glGetProgramInfoLog(program, log.length, length, 0, log, 0);
        return new String(log, 0, length[0], StandardCharsets.UTF_8);
    }
}
