package sunbeam.precompute.patch;

/**
 * Heights as an image stores them: samples without a scale, row by row from the top. Package-private, and the array is
 * handed over rather than copied.
 */
final class HeightImage {
    private final int columns;
    private final int rows;
    private final SampleFormat format;
    private final String description;
    private final double[] samples;

    /**
     * @param samples {@code rows * columns} raw samples, NaN where missing; taken over
     * @param description what the image is, for people: "8-bit RGB PNG, red channel"
     */
    HeightImage(int columns, int rows, SampleFormat format, String description, double[] samples) {
        this.columns = columns;
        this.rows = rows;
        this.format = format;
        this.description = description;
        this.samples = samples;
    }

    int columns() {
        return columns;
    }

    int rows() {
        return rows;
    }

    SampleFormat format() {
        return format;
    }

    String description() {
        return description;
    }

    /** Raw samples, row by row; the array itself. */
    double[] samples() {
        return samples;
    }
}
