package jrtr;

/**
 * One error of a shader compiler or linker, with its line in the shader file before include expansion.
 *
 * @param file name of the shader file, as the {@linkplain ShaderSource source} names it
 * @param line line in that file, counted from 1; 0 where the message has no place
 * @param message the driver's words
 * @param sourceLine the offending line's text; empty where the message has no place
 */
public record ShaderProblem(String file, int line, String message, String sourceLine) {

    /** {@code file:line: message: `offending line`}, without the parts that are unknown. */
    public String describe() {
        String place = line > 0 ? file + ":" + line : file;
        String quote = sourceLine.isBlank() ? "" : ": `" + sourceLine.strip() + "`";
        return place + ": " + message + quote;
    }
}
