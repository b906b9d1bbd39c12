package jrtr;

import java.util.List;

/**
 * The complete text of one shader stage, includes expanded, with the origin of each of its lines. Made by {@link
 * jrtr.glsl.ShaderLibrary#load}.
 *
 * @param name name of the root file
 * @param text the compiler's input: ASCII, lines end with {@code \n}
 * @param origins origin of each line of the text; one element per line
 */
public record ShaderSource(String name, String text, List<SourceLine> origins) {

    /** Checks that every line has an origin. */
    public ShaderSource {
        origins = List.copyOf(origins);
        long lines = text.chars().filter(character -> character == '\n').count();
        if (lines != origins.size()) {
            throw new IllegalArgumentException(
                    "shader " + name + ": " + lines + " lines of text but " + origins.size() + " origins");
        }
    }
}
