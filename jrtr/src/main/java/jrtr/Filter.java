package jrtr;

/** Interpolation between texel centers, which lie at (i + 1/2) / size. */
public enum Filter {
    /** The nearest texel, bit for bit. */
    NEAREST,
    /** Bilinear interpolation within a layer. Weights may have as few as 8 bits on some hardware. */
    LINEAR
}
