package jrtr;

/**
 * One message of a shader compiler or linker, at its place in the files that the author wrote.
 *
 * @param severity error or warning
 * @param file name of the shader file, as the {@linkplain ShaderSource source} names it
 * @param line line in that file, counted from 1; 0 where the message has no place
 * @param message the driver's words
 * @param sourceLine the offending line's text; empty where the message has no place
 */
public record ShaderProblem(Severity severity, String file, int line, String message, String sourceLine) {

    /** How grave a message is. */
    public enum Severity {
        ERROR,
        WARNING
    }

    /** Whether this stops the shader from being used. */
    public boolean isError() {
        return severity == Severity.ERROR;
    }

    /** {@code file:line: message: `offending line`}, as far as the place is known. */
    public String describe() {
        String place = line > 0 ? file + ":" + line : file;
        String quote = sourceLine.isBlank() ? "" : ": `" + sourceLine.strip() + "`";
        return place + ": " + message + quote;
    }
}
