package sunbeam.precompute.scan;

import java.util.Optional;

/**
 * One channel of a scan, known from the file's header.
 *
 * @param name as the file calls it; may be empty
 * @param retrace whether the tip went backward while it was recorded
 * @param samples in their unit, read when they are asked for
 * @param unit of the samples as written; empty when the file does not say
 */
public record ScanChannel(String name, boolean retrace, Samples samples, Extent extent, String unit) {
    /** Unit of whole numbers of which the file only knows that full scale is 1: an image's. */
    public static final String FULL_SCALE = "full scale";

    public ScanChannel {
        name = name.strip();
        unit = unit.strip();
    }

    /** A channel of a file that does not say which way the tip went. */
    public ScanChannel(String name, Samples samples, Extent extent, String unit) {
        this(name, false, samples, extent, unit);
    }

    /** The same samples in rows of another length. */
    public ScanChannel inRows(int columns, int rows) {
        return new ScanChannel(name, retrace, samples.inRows(columns, rows), extent, unit);
    }

    public int columns() {
        return samples.columns();
    }

    public int rows() {
        return samples.rows();
    }

    /** Meters of one unit of the samples; nothing when the unit is none of length, or not known. */
    public Optional<Double> metersPerUnit() {
        return LengthUnit.meters(unit);
    }

    /** Whether the samples may be heights: in a unit of length, of full scale, or without any unit. */
    public boolean maybeHeights() {
        return unit.isEmpty() || unit.equals(FULL_SCALE) || metersPerUnit().isPresent();
    }
}
