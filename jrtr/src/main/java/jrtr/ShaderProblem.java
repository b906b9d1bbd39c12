package jrtr;

/**
 * One error of a shader compiler or linker, with its line in the shader file before include expansion.
 *
 * @param file name of the shader file, as in {@link ShaderSource}
 * @param line line in that file, counted from 1; 0 if the message names no line
 * @param message the driver's message without the line number
 * @param sourceLine the offending line's text; empty if the message names no line
 */
public record ShaderProblem(String file, int line, String message, String sourceLine) {

    /** Returns {@code file:line: message: `offending line`}, without unknown parts. */
    public String describe() {
        String place = line > 0 ? file + ":" + line : file;
        String quote = sourceLine.isBlank() ? "" : ": `" + sourceLine.strip() + "`";
        return place + ": " + message + quote;
    }
}
