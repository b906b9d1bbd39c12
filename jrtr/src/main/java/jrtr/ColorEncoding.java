package jrtr;

/** Meaning of an image's bytes. */
public enum ColorEncoding {
    /** sRGB (IEC 61966-2-1) in red, green and blue; the sampler gives linear light. Alpha is linear. */
    SRGB,
    /** Byte / 255, as for masks and normal maps. */
    LINEAR
}
