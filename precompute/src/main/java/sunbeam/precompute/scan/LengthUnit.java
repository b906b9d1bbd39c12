package sunbeam.precompute.scan;

import java.util.Locale;
import java.util.Optional;

/** Parser of units of length in instruments' spellings: "nm", "µm" in any encoding, "~m" (Bruker's micrometer), "Å". */
public final class LengthUnit {
    private LengthUnit() {}

    /** Returns meters per unit; empty if the text is no unit of length. */
    public static Optional<Double> meters(String unit) {
        String plain = unit.strip()
                .replaceAll("\u00c2?[\u00b5\u03bc~\u00e6]", "u")
                .replaceAll("A\u030a|[\u212b\u00c5]", "\u00e5");
        double meters = switch (plain.length() > 2 ? plain.toLowerCase(Locale.ROOT) : plain) {
            case "fm" -> 1e-15;
            case "pm" -> 1e-12;
            case "ang", "angstrom", "angstroms", "\u00e5" -> 1e-10;
            case "nm", "nanometer", "nanometre" -> 1e-9;
            case "um", "micron", "microns", "micrometer", "micrometre" -> 1e-6;
            case "mm" -> 1e-3;
            case "cm" -> 1e-2;
            case "m", "meter", "metre" -> 1;
            default -> 0;
        };
        return meters > 0 ? Optional.of(meters) : Optional.empty();
    }
}
