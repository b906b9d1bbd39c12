package sunbeam.precompute.patch;

/** How an image stores a height, and which sample is full scale: the one that stands for {@code maxHeight}. */
enum SampleFormat {
    UNSIGNED_8("8-bit", 255, true),
    UNSIGNED_16("16-bit", 65_535, true),
    /** Half of the samples is negative; full scale is the whole range, so that steps are those of unsigned samples. */
    SIGNED_16("signed 16-bit", 65_535, true),
    /** {@code maxHeight} is the height of the sample 1.0; samples beyond it are allowed. */
    FLOAT("float", 1, false);

    private final String label;
    private final double fullScale;
    private final boolean integer;

    SampleFormat(String label, double fullScale, boolean integer) {
        this.label = label;
        this.fullScale = fullScale;
        this.integer = integer;
    }

    /** For people: "8-bit". */
    String label() {
        return label;
    }

    /** The sample that stands for {@code maxHeight}. */
    double fullScale() {
        return fullScale;
    }

    boolean integer() {
        return integer;
    }
}
