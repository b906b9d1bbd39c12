package sunbeam.precompute.cause;

/** What a plan errs by (docs/error-budget.md), in the order in which approximations are made. */
public enum ErrorSource {
    /** Wavelengths between which nothing is looked at; single orders, each for itself. Colours only. */
    WAVELENGTHS("the wavelengths"),
    /** Terms that exp(i k w h) goes without, and the basis of an ensemble's powers. */
    EXPANSION("the expansion"),
    /** Bins beyond the neighbourhood, or interpolation on a grid. */
    WINDOW("the neighbourhood of bins or the grid in its place"),
    /** Bins beyond the table. */
    CROP("the table's bands of bins"),
    /** Rounding, and the tables that shaders interpolate: what is left when all else is computed in double precision. */
    FLOAT32("float32 on the graphics card");

    private final String words;

    ErrorSource(String words) {
        this.words = words;
    }

    /** With its article. */
    public String words() {
        return words;
    }
}
