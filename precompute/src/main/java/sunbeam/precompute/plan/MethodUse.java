package sunbeam.precompute.plan;

public enum MethodUse {
    /** Colors of directions, over all wavelengths. */
    COLOR,
    /** Coherent and ensemble power at single wavelengths. */
    SPECTRAL
}
