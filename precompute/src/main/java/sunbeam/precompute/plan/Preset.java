package sunbeam.precompute.plan;

/** Where choices come from that the user does not make. */
public enum Preset {
    /** Planned for the tolerance. */
    NONE,
    /** The thesis's shader: 37 Taylor terms, 5 nm, 3 x 3 bins anchored with floor, window on the corner. */
    THESIS
}
