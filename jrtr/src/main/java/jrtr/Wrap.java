package jrtr;

/** Addressing of texture coordinates outside [0, 1]. */
public enum Wrap {
    /** Repeats the texel at the edge. */
    CLAMP,
    /** Repeats the texture periodically. */
    REPEAT
}
