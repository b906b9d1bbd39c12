package jrtr;

import java.util.List;

/**
 * Complete text of one shader stage, with expanded includes and the origin of each line. {@link jrtr.glsl.ShaderLibrary#load} creates it.
 *
 * @param name of the root file
 * @param text the compiler's input: ASCII, lines end with {@code \n}
 * @param origins origin of each line of the text; one element per line
 */
public record ShaderSource(String name, String text, List<SourceLine> origins) {

    public ShaderSource {
        origins = List.copyOf(origins);
        long lines = text.chars().filter(character -> character == '\n').count();
        if (lines != origins.size()) {
            throw new IllegalArgumentException(
                    "shader " + name + ": " + lines + " lines of text but " + origins.size() + " origins");
        }
    }
}
