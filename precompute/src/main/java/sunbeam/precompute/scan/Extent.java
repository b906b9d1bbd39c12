package sunbeam.precompute.scan;

import java.util.Locale;
import java.util.Optional;

/**
 * Size of a channel in meters; empty sides are not stated by the file.
 *
 * @param aspect pitch of rows over that of columns if the file states no lengths, else 1
 */
public record Extent(Optional<Double> width, Optional<Double> height, double aspect) {
    public static final Extent UNKNOWN = new Extent(Optional.empty(), Optional.empty(), 1);

    /** Refuses a length that is not positive and finite. */
    public Extent {
        width.ifPresent(Extent::require);
        height.ifPresent(Extent::require);
        require(aspect);
    }

    public static Extent of(double width, double height) {
        return new Extent(Optional.of(width), Optional.of(height), 1);
    }

    /** Computes the size from the pitches; only the aspect is known if the unit is no unit of length. */
    public static Extent ofPitches(double pitchX, double pitchY, String unit, Samples samples) {
        require(pitchX);
        require(pitchY);
        return metersPer(unit)
                .map(meters -> of(samples.columns() * pitchX * meters, samples.rows() * pitchY * meters))
                .orElseGet(() -> new Extent(Optional.empty(), Optional.empty(), pitchY / pitchX));
    }

    public static Extent ofSides(double width, double height, String unit, Samples samples) {
        return ofPitches(width / samples.columns(), height / samples.rows(), unit, samples);
    }

    private static void require(double length) {
        if (!(length > 0) || !Double.isFinite(length)) {
            throw new ScanException("claims a side of " + length + "; the file is damaged, export it again");
        }
    }

    /** Returns meters per unit, in instruments' spellings: "µm" in any encoding, "~m" (Bruker's micrometer). */
    public static Optional<Double> metersPer(String unit) {
        String plain = unit.strip()
                .replaceAll("\u00c2?[\u00b5\u03bc~\u00e6]", "u")
                .replaceAll("A\u030a|[\u212b\u00c5]", "\u00e5");
        double meters = switch (plain.length() > 2 ? plain.toLowerCase(Locale.ROOT) : plain) {
            case "fm" -> 1e-15;
            case "pm" -> 1e-12;
            case "ang", "angstrom", "angstroms", "\u00e5" -> 1e-10;
            case "nm", "nanometer", "nanometre", "nanometers", "nanometres" -> 1e-9;
            case "um", "micron", "microns", "micrometer", "micrometre", "micrometers", "micrometres" -> 1e-6;
            case "mm", "millimeter", "millimetre", "millimeters", "millimetres" -> 1e-3;
            case "cm", "centimeter", "centimetre", "centimeters", "centimetres" -> 1e-2;
            case "in", "inch", "inches" -> 25.4e-3;
            case "m", "meter", "metre", "meters", "metres" -> 1;
            default -> 0;
        };
        return meters > 0 ? Optional.of(meters) : Optional.empty();
    }
}
