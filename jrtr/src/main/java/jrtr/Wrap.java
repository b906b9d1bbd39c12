package jrtr;

/** What a sampler gives outside [0, 1]. */
public enum Wrap {
    /** The texel at the edge. */
    CLAMP,
    /** The texture again, periodically. */
    REPEAT
}
