package sunbeam.precompute.shader;

/** Use of a method; its tables hold no more than the use needs. */
public enum MethodUse {
    /** Colors of directions, over all wavelengths. */
    COLOR,
    /** Coherent and ensemble power at single wavelengths. */
    SPECTRAL
}
