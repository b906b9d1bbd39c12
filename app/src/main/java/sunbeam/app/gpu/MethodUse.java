package sunbeam.app.gpu;

/** What a method is asked for; it uploads no more than that needs. */
public enum MethodUse {
    /** Colours: all wavelengths of a direction. */
    COLOUR,
    /** Coherent and ensemble power at single wavelengths. */
    SPECTRAL
}
