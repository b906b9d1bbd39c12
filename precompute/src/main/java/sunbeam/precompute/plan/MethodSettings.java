package sunbeam.precompute.plan;

import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import sunbeam.precompute.color.CieTable.Observer;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.PeriodInterpolation;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Settings of the methods, their plans and the light. Each method lists its own (see {@link sunbeam.precompute.method.MethodType}). */
public final class MethodSettings {
    // Half the visible band, so that both its ends are sampled, in meters.
    private static final double LARGEST_STEP = 200e-9;
    private static final double SMALLEST_STEP = 1e-12;
    private static final int MOST_TERMS = 500;

    public static final Setting<Preset> PRESET = new Setting<>(
            "preset",
            ValueKind.word("PRESET", Preset.class),
            "thesis: the thesis's values, each of which other options override: 37 Taylor terms, 380..780 nm in steps of"
                    + " 5 nm, 3 x 3 bins anchored with floor, window on the corner, coherent average, Fresnel's factor"
                    + " squared, CIE RGB, clipped highlights, light blended over meshes by Fresnel's factor, pq by ring, gem in"
                    + " the thesis's form.");

    public static final Setting<FresnelFactor> FRESNEL = new Setting<>(
            "fresnel",
            ValueKind.word("COUNT", FresnelFactor.class),
            "Power of Fresnel's reflectance in the radiance: once (default) or squared (thesis).");

    public static final Setting<Double> TOLERANCE = new Setting<>(
                    "tolerance",
                    ValueKind.number(
                            "ERROR",
                            ErrorBudget.FINEST,
                            ErrorBudget.COARSEST,
                            Text.format(
                                    "finer than float32 can reach, which is %s; give that or more, or evaluate directions by"
                                            + " method reference",
                                    Decimals.format(ErrorBudget.FINEST))),
                    "Relative error of power and color, 1e-5 to 1, which determines terms, bins and wavelengths. Below"
                            + " 2e-5 float32 keeps it in the median, but not three times it at the 95th percentile;"
                            + " method reference is more exact.")
            .withStandard(ErrorBudget.STANDARD);

    public static final Setting<Expansion.Kind> EXPANSION = new Setting<>(
            "expansion", ValueKind.word("KIND", Expansion.Kind.class), "Expansion of exp(i k w h): taylor or lowrank.");

    public static final Setting<Integer> TERMS =
            new Setting<>("terms", ValueKind.integer("N", 1, MOST_TERMS), "Number of terms of the expansion.");

    public static final Setting<Integer> RADIUS = new Setting<>(
            "radius",
            ValueKind.integer("R", 0, 15),
            "With preset thesis: sum (2 R + 1) x (2 R + 1) DFT bins around each frequency.");

    public static final Setting<Neighborhood.Anchor> ANCHOR = new Setting<>(
            "anchor",
            ValueKind.word("BIN", Neighborhood.Anchor.class),
            "With preset thesis: the central bin, floor (default) or nearest.");

    public static final Setting<Double> WAVELENGTH_STEP = new Setting<>(
            "wavelengthStep",
            ValueKind.length(SMALLEST_STEP, LARGEST_STEP),
            "Equal steps of the wavelength, for example 5nm.");

    public static final Setting<WindowOrigin> WINDOW_ORIGIN = new Setting<>(
            "windowOrigin",
            ValueKind.word("PLACE", WindowOrigin.class),
            "Place of the coherence window's maximum on the patch: centre (default) or corner (thesis).");

    /** Four standard deviations of the window, meters. */
    public static final Setting<Double> COHERENCE_LENGTH = new Setting<>(
                    "coherenceLength",
                    ValueKind.length(100e-9, 10e-3),
                    "Four standard deviations of the coherence window, 100nm to 10mm; sunlight: 65 um.")
            .withStandard(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);

    public static final Setting<Average> AVERAGE = new Setting<>(
                    "average",
                    ValueKind.word("KIND", Average.class),
                    "coherent: one coherence area, with speckle. ensemble: the mean over all positions of the window.")
            .withStandard(Average.COHERENT);

    public static final Setting<PeriodInterpolation> INTERPOLATION = new Setting<>(
            "interpolation",
            ValueKind.word("KIND", PeriodInterpolation.class),
            "For pq: interpolation between the bins of one period's DFT: sinc (default), linear, or ring (sinc over nine bins, thesis).");

    public static final Setting<Integer> REPLICAS = new Setting<>(
            "replicas",
            ValueKind.integer("Q", 1, Replicas.MOST),
            "For pq: repeat the patch Q times along both axes. Default: the number that fills the coherence length. For"
                    + " reference: sum over these replicas instead of the Gaussian window.");

    /** Distance of a grating's lines, meters. Finer lines diffract no visible light; coarser ones are no grating. */
    public static final Setting<Double> SPACING = new Setting<>(
            "spacing",
            ValueKind.length(100e-9, 1e-3),
            "For gem: distance of the grating's lines, which run along y. Default: the patch's width, for patches of one"
                    + " period.");

    public static final Setting<Integer> ORDERS = new Setting<>(
            "orders",
            ValueKind.integer("N", 1, 100),
            "For gem: orders on each side of the mirror's: 8 (default, GPU Gems); in the thesis's form all visible ones.");

    public static final Setting<GemForm> GEM_FORM = new Setting<>(
            "gemForm",
            ValueKind.word("FORM", GemForm.class),
            "For gem: stam (default, GPU Gems), or thesis (its program for maps): light at |v| < 0.01 only, times"
                    + " exp(-(1.5 u / w)^2).");

    /** One of {@link Illuminant#NAMES}, or a CSV file. */
    public static final Setting<String> ILLUMINANT = new Setting<>(
                    "illuminant",
                    ValueKind.text(
                            "LIGHT",
                            MethodSettings::illuminant,
                            UnaryOperator.identity(),
                            String.join(", ", Illuminant.NAMES) + ", or a file (.csv)"),
                    // The first sentence, all of the short help, does not grow with the names.
                    "Spectrum of the light: D65, D50, A or another name, or a CSV file. Names: "
                            + String.join(", ", Illuminant.NAMES)
                            + " (E: equal power). The file has columns of wavelengths in nm, 380 to 780 in steps of at most 20, and of"
                            + " power.")
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

    public static final List<Setting<?>> LIGHT = List.of(ILLUMINANT, WAVELENGTHS, OBSERVER);

    private MethodSettings() {}

    public static boolean isLightFile(String illuminant) {
        return illuminant.toLowerCase(Locale.ROOT).endsWith(".csv");
    }

    private static String illuminant(String text) {
        String name = text.strip();
        if (isLightFile(name)) {
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

    /** Form of the grating formula of method gem (shaders/method/gem.glsl). */
    public enum GemForm {
        /** J. Stam's, GPU Gems, chapter 8: colors in all directions, as linear sRGB. */
        STAM,
        /** Form of the thesis's program for maps: colors as XYZ, a tenth as bright, along the grating alone, fading away from the mirror. */
        THESIS
    }
}
