package jrtr;

import java.util.List;

/**
 * Thrown if a shader cannot be assembled, compiled, linked, or given a uniform. If the fault has a line, the message starts
 * with {@code file:line:} and quotes it.
 */
public class ShaderException extends GraphicsException {
    private static final long serialVersionUID = 1L;

    public ShaderException(String message) {
        super(message);
    }

    /**
     * @param doing the failed step, such as "compiling full.frag.glsl"
     * @param problems the compiler's errors; not empty
     */
    public ShaderException(String doing, List<ShaderProblem> problems) {
        super(summary(doing, problems));
    }

    private static String summary(String doing, List<ShaderProblem> problems) {
        int more = problems.size() - 1;
        return problems.get(0).describe() + " [" + doing + (more > 0 ? ", and " + more + " more" : "") + "]";
    }
}
