package jrtr;

/** Addressing of texture coordinates outside [0, 1]. */
public enum Wrap {
    /** The texel at the edge. */
    CLAMP,
    /** The texture again, periodically. */
    REPEAT
}
