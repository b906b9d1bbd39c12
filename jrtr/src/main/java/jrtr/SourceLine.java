package jrtr;

/**
 * Line of a shader file before include expansion.
 *
 * @param file name of the shader file, or {@code <defines>} for the generated prologue
 * @param number line number, counted from 1
 * @param text the line, comments included, without its line break
 */
public record SourceLine(String file, int number, String text) {}
