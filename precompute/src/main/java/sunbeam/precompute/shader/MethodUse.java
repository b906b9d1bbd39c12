package sunbeam.precompute.shader;

/** What a method is asked for; its tables hold no more than that needs. */
public enum MethodUse {
    /** Colors: all wavelengths of a direction. */
    COLOR,
    /** Coherent and ensemble power at single wavelengths. */
    SPECTRAL
}
