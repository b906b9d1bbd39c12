package sunbeam.precompute.scan;

import java.util.Optional;

/**
 * Size of the area that a channel covers.
 *
 * @param width along x, meters; empty if the file does not state it
 * @param height along y, meters; empty if the file does not state it
 * @param aspect distance between rows divided by that between columns if the file states no lengths, else 1
 */
public record Extent(Optional<Double> width, Optional<Double> height, double aspect) {
    /** Unknown size, square samples. */
    public static final Extent UNKNOWN = new Extent(Optional.empty(), Optional.empty(), 1);

    /** @throws ScanException if a length is not positive and finite */
    public Extent {
        width.ifPresent(Extent::require);
        height.ifPresent(Extent::require);
        require(aspect);
    }

    public static Extent of(double width, double height) {
        return new Extent(Optional.of(width), Optional.of(height), 1);
    }

    /**
     * Computes the size from the distances between columns and between rows. If the unit is no unit of length, only the aspect is known.
     */
    public static Extent ofPitches(double pitchX, double pitchY, String unit, Samples samples) {
        require(pitchX);
        require(pitchY);
        return LengthUnit.meters(unit)
                .map(meters -> of(samples.columns() * pitchX * meters, samples.rows() * pitchY * meters))
                .orElseGet(() -> new Extent(Optional.empty(), Optional.empty(), pitchY / pitchX));
    }

    /** Like {@link #ofPitches}, from the lengths of the whole area. */
    public static Extent ofSides(double width, double height, String unit, Samples samples) {
        return ofPitches(width / samples.columns(), height / samples.rows(), unit, samples);
    }

    private static void require(double length) {
        if (!(length > 0) || !Double.isFinite(length)) {
            throw new ScanException("claims a side of " + length + "; the file is damaged, export it again");
        }
    }
}
