package sunbeam.precompute.color;

/** The CIE's standard observers (CIE 018:2019). */
public enum Observer {
    /** CIE 1931, a field of 2 degrees, by which sRGB is defined. */
    CIE1931("CIE 1931, 2 degrees", ""),
    /** CIE 1964, a field of 10 degrees. */
    CIE1964("CIE 1964, 10 degrees", "_10");

    private final String label;
    private final String suffix;

    Observer(String label, String suffix) {
        this.label = label;
        this.suffix = suffix;
    }

    /** Returns the name in messages. */
    public String label() {
        return label;
    }

    /** Returns a color matching function at each nanometer from 380 to 780 nm; 0 for X, 1 for Y, 2 for Z. */
    double[] matching(int channel) {
        return CieData.column("xyz".charAt(channel) + "_bar" + suffix);
    }
}
