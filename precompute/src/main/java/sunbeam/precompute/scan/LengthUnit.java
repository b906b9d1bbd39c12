package sunbeam.precompute.scan;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Units of length as instruments write them: "nm", "µm" in any encoding, "~m" (Bruker's micrometre), "Å". */
public final class LengthUnit {
    private static final Map<String, Double> METRES = Map.ofEntries(
            Map.entry("fm", 1e-15),
            Map.entry("pm", 1e-12),
            Map.entry("ang", 1e-10),
            Map.entry("angstrom", 1e-10),
            Map.entry("angstroms", 1e-10),
            Map.entry("\u00e5", 1e-10),
            Map.entry("nm", 1e-9),
            Map.entry("nanometer", 1e-9),
            Map.entry("nanometre", 1e-9),
            Map.entry("um", 1e-6),
            Map.entry("micron", 1e-6),
            Map.entry("microns", 1e-6),
            Map.entry("micrometer", 1e-6),
            Map.entry("micrometre", 1e-6),
            Map.entry("mm", 1e-3),
            Map.entry("cm", 1e-2),
            Map.entry("m", 1.0),
            Map.entry("meter", 1.0),
            Map.entry("metre", 1.0));

    private LengthUnit() {}

    /** Metres of one such unit; nothing when it is no unit of length. */
    public static Optional<Double> metres(String unit) {
        String plain = unit.strip()
                .replace('\u00b5', 'u')
                .replace('\u03bc', 'u')
                .replace('~', 'u')
                .replace("\u00c2u", "u")
                .replace("A\u030a", "\u00e5")
                .replace('\u212b', '\u00e5')
                .replace('\u00c5', '\u00e5');
        return Optional.ofNullable(METRES.get(plain.length() > 2 ? plain.toLowerCase(Locale.ROOT) : plain));
    }
}
