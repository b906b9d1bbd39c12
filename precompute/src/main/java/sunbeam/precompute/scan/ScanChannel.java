package sunbeam.precompute.scan;

import java.util.Optional;

/** Channel of a scan: the tip may move backward; the unit is as written in the file, empty if not stated. */
public record ScanChannel(String name, boolean retrace, Samples samples, Extent extent, String unit) {
    /** Unit of an image's samples: 1 is full scale. */
    public static final String FULL_SCALE = "full scale";

    public ScanChannel {
        name = name.strip();
        unit = unit.strip();
    }

    public ScanChannel(String name, Samples samples, Extent extent, String unit) {
        this(name, false, samples, extent, unit);
    }

    public ScanChannel reshape(int columns, int rows) {
        return new ScanChannel(name, retrace, new Samples(columns, rows, samples.source()), extent, unit);
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
