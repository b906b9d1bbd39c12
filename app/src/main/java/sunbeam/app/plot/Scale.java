package sunbeam.app.plot;

/** How values are laid out along an axis. */
public enum Scale {
    LINEAR,
    /** Decimal logarithm; values must be positive. */
    LOGARITHMIC
}
