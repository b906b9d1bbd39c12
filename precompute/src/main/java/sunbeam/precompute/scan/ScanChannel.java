package sunbeam.precompute.scan;

import java.util.Optional;

/**
 * Channel of a scan: the tip may move backward; the unit is as written in the file, empty if not stated.
 *
 * @param span full scale of an image's samples minus their zero, in the unit; NaN for files without full scale
 * @param note how the file's stored samples were scaled by a declaration that users may not know of; empty if there is none
 */
public record ScanChannel(
        String name, boolean retrace, Samples samples, Extent extent, String unit, double span, String note) {
    /** Unit of an image's samples: 1 is full scale. */
    public static final String FULL_SCALE = "full scale";

    /** Name of the heights of a profile, which are a surface that is constant along y. */
    public static final String PROFILE = "profile (constant along y)";

    public ScanChannel {
        name = name.strip();
        unit = unit.strip();
    }

    public ScanChannel(String name, boolean retrace, Samples samples, Extent extent, String unit) {
        // Numbers without a unit count as shares of a full scale of 1.
        this(name, retrace, samples, extent, unit, unit.isBlank() || unit.equals(FULL_SCALE) ? 1 : Double.NaN, "");
    }

    public ScanChannel(String name, Samples samples, Extent extent, String unit) {
        this(name, false, samples, extent, unit);
    }

    public ScanChannel reshape(int columns, int rows) {
        return new ScanChannel(name, retrace, new Samples(columns, rows, samples.source()), extent, unit, span, note);
    }

    ScanChannel calibrated(double fullScale, String how) {
        return new ScanChannel(name, retrace, samples, extent, unit, fullScale, how);
    }

    /** Such as "512 x 512 samples, in nm". */
    public String describe() {
        return columns() + " x " + rows() + " samples, " + (unit.isEmpty() ? "no unit" : "in " + unit);
    }

    public int columns() {
        return samples.columns();
    }

    public int rows() {
        return samples.rows();
    }

    public Optional<Double> metersPerUnit() {
        return Extent.metersPer(unit);
    }

    /** True for samples in a unit of length, of full scale, or without a unit. */
    public boolean maybeHeights() {
        return unit.isEmpty() || unit.equals(FULL_SCALE) || metersPerUnit().isPresent();
    }
}
