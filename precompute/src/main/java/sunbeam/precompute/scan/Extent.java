package sunbeam.precompute.scan;

import java.util.Optional;

/**
 * How large a channel is.
 *
 * @param width along x of all columns together, meters; empty when the file does not say
 * @param height along y of all rows together, meters; empty when the file does not say
 * @param aspect distance of rows over distance of columns, as far as the file says; 1 for square samples
 */
public record Extent(Optional<Double> width, Optional<Double> height, double aspect) {
    /** The file does not say; samples are taken for square. */
    public static final Extent UNKNOWN = new Extent(Optional.empty(), Optional.empty(), 1);

    /** @throws ScanException when a length is none */
    public Extent {
        width.ifPresent(Extent::require);
        height.ifPresent(Extent::require);
        require(aspect);
    }

    /** Of both sides, meters. */
    public static Extent of(double width, double height) {
        return new Extent(Optional.of(width), Optional.of(height), 1);
    }

    /**
     * Of samples at distances in a unit; where that is no unit of length, only the ratio of the distances is known.
     *
     * @param pitchX distance of columns
     * @param pitchY distance of rows
     */
    public static Extent ofPitches(double pitchX, double pitchY, String unit, Samples samples) {
        require(pitchX);
        require(pitchY);
        return LengthUnit.meters(unit)
                .map(meters -> of(samples.columns() * pitchX * meters, samples.rows() * pitchY * meters))
                .orElseGet(() -> new Extent(Optional.empty(), Optional.empty(), pitchY / pitchX));
    }

    /** As {@link #ofPitches}, of all columns and all rows together. */
    public static Extent ofSides(double width, double height, String unit, Samples samples) {
        return ofPitches(width / samples.columns(), height / samples.rows(), unit, samples);
    }

    private static void require(double length) {
        if (!(length > 0) || !Double.isFinite(length)) {
            throw new ScanException("claims a side of " + length + "; the file is damaged, export it again");
        }
    }
}
