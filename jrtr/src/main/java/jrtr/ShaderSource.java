package jrtr;

import java.util.List;

/**
 * Complete text of one shader stage, with expanded includes and the origin of each line. {@link jrtr.glsl.ShaderLibrary#load} creates it.
 *
 * @param name of the root file
 * @param text the compiler's input: ASCII, lines end with {@code \n}
 * @param origins origin of each line of the text; one element per line
 */
public record ShaderSource(String name, String text, List<Line> origins) {
    /**
     * Line of a shader file before include expansion.
     *
     * @param file name of the shader file, or {@code <defines>} for the generated prologue
     * @param number line number, counted from 1
     * @param text the line, comments included, without its line break
     */
    public record Line(String file, int number, String text) {
        /** Returns {@code file:line: message: `the line`}. */
        public String describe(String message) {
            return file + ":" + number + ": " + message + (text.isBlank() ? "" : ": `" + text.strip() + "`");
        }
    }

    public ShaderSource {
        origins = List.copyOf(origins);
        long lines = text.chars().filter(character -> character == '\n').count();
        if (lines != origins.size()) {
            throw new IllegalArgumentException(
                    "shader " + name + ": " + lines + " lines of text but " + origins.size() + " origins");
        }
    }
}
