package jrtr;

/**
 * One error of a shader compiler or linker, at its place in the files that the author wrote.
 *
 * @param file name of the shader file, as the {@linkplain ShaderSource source} names it
 * @param line line in that file, counted from 1; 0 where the message has no place
 * @param message the driver's words
 * @param sourceLine the offending line's text; empty where the message has no place
 */
public record ShaderProblem(String file, int line, String message, String sourceLine) {

    /** {@code file:line: message: `offending line`}, as far as the place is known. */
    public String describe() {
        String place = line > 0 ? file + ":" + line : file;
        String quote = sourceLine.isBlank() ? "" : ": `" + sourceLine.strip() + "`";
        return place + ": " + message + quote;
    }
}
