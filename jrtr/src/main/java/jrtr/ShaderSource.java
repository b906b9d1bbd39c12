package jrtr;

import java.util.List;

/**
 * The complete text of one shader stage, includes expanded, with the origin of each of its lines. Made by {@link
 * jrtr.glsl.ShaderLibrary#load}.
 *
 * @param name name of the root file
 * @param text what the compiler gets; ASCII, lines ended by {@code \n}
 * @param origins where each line of the text comes from; as many as the text has lines
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
