package sunbeam.precompute.plan;

import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import sunbeam.precompute.color.CieTable.Observer;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;

/** Settings of the light and the observer. */
public final class LightSettings {
    /** One of {@link Illuminant#NAMES}, or a CSV file. */
    public static final Setting<String> ILLUMINANT = new Setting<>(
                    "illuminant",
                    ValueKind.text(
                            "LIGHT",
                            LightSettings::illuminant,
                            UnaryOperator.identity(),
                            String.join(", ", Illuminant.NAMES) + ", or a file (.csv)"),
                    "Spectrum of the light: " + String.join(", ", Illuminant.NAMES)
                            + " (E: equal power), or a CSV file: columns of wavelengths in nm, 380 to 780 in steps of at most 20,"
                            + " and of power.")
            .withStandard("D65");

    public static final Setting<WavelengthBand> WAVELENGTHS = new Setting<>(
                    "wavelengths",
                    ValueKind.text(
                            "BAND",
                            WavelengthBand::parse,
                            WavelengthBand::toString,
                            "a wavelength, 532nm, or a band, 500nm..600nm"),
                    "Light through a filter, a band such as 500nm..600nm, or of a laser, a wavelength such as 532nm (a line 1 nm wide).")
            .withStandard(WavelengthBand.VISIBLE);

    public static final Setting<Observer> OBSERVER = new Setting<>(
                    "observer",
                    ValueKind.word("OBSERVER", Observer.class),
                    "Color matching functions: cie1931 (2 degrees) or cie1964 (10 degrees).")
            .withStandard(Observer.CIE1931);

    public static final List<Setting<?>> ALL = List.of(ILLUMINANT, WAVELENGTHS, OBSERVER);

    private LightSettings() {}

    public static boolean isFile(String illuminant) {
        return illuminant.toLowerCase(Locale.ROOT).endsWith(".csv");
    }

    private static String illuminant(String text) {
        String name = text.strip();
        if (isFile(name)) {
            return name;
        }
        return Illuminant.NAMES.stream()
                .filter(name::equalsIgnoreCase)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Text.quoted(text) + " is not one of "
                        + String.join(", ", Illuminant.NAMES) + ", nor a file (.csv)"
                        + Text.nearest(name, Illuminant.NAMES)
                                .map(near -> " (did you mean " + near + "?)")
                                .orElse("")));
    }
}
