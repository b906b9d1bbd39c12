package jrtr;

import java.util.List;

/**
 * A shader that cannot be assembled, compiled, linked or fed. The message starts with {@code file:line:} wherever the
 * fault has a place, and quotes that line.
 */
public class ShaderException extends GraphicsException {
    private static final long serialVersionUID = 1L;

    /** @param message what failed and how to mend it */
    public ShaderException(String message) {
        super(message);
    }

    /**
     * @param doing what was being done, such as "compiling full.frag.glsl"
     * @param problems the errors that the compiler named; not empty
     */
    public ShaderException(String doing, List<ShaderProblem> problems) {
        super(summary(doing, problems));
    }

    private static String summary(String doing, List<ShaderProblem> problems) {
        int more = problems.size() - 1;
        return problems.get(0).describe() + " [" + doing + (more > 0 ? ", and " + more + " more" : "") + "]";
    }
}
