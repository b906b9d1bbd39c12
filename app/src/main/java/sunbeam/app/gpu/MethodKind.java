package sunbeam.app.gpu;

import java.util.Locale;

/** The diffraction methods by their names at the command line (docs/methods.md). */
public enum MethodKind {
    /** Direct sums in double precision on the processor: the truth. */
    REFERENCE,
    /** Every wavelength of the planned or the thesis's sampling. */
    FULL,
    /** One wavelength per diffraction order, weighted by the order's width. */
    NMM,
    /** The patch repeated Q times, sharp edge instead of a Gaussian window. */
    PQ,
    /** A grating's spacing and nothing else; for comparison only. */
    GEM;

    /** Lower-case name. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
