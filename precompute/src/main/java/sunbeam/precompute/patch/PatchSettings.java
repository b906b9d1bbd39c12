package sunbeam.precompute.patch;

import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.setting.Kinds;
import sunbeam.precompute.setting.Setting;

/**
 * What a user chooses of a patch. The limits are wide enough for every surface that the model can say something about, and
 * narrow enough to catch nanometres typed for micrometres.
 */
public final class PatchSettings {
    /** Extent of an image along x, metres. */
    public static final Setting<Double> WIDTH =
            side("width", "Extent along x of an image, or of a file that does not say it, for example 65um.");

    /** Extent of an image along y, metres. */
    public static final Setting<Double> HEIGHT =
            side("height", "Extent along y of such a file. Default: square pixels.");

    /** Height of full scale, metres: of 255 of 8 bits, 65535 of 16 bits, 1.0 of float. Float images may hold metres. */
    public static final Setting<Double> MAX_HEIGHT = new Setting<>(
            "maxHeight",
            Kinds.length(1e-12, 1),
            "Height of an image's full scale (255, 65535, or 1.0), for example 375nm.");

    /** Which surface. */
    public static final Setting<String> PATCH = new Setting<>(
                    "patch",
                    Kinds.text("PATCH"),
                    "The surface: a built-in patch (blaze, sinusoid, lamellar, disc, elaphe-like, xenopeltis-like), a"
                            + " descriptor (.json), a scan in its instrument's format, or an image (PNG, TIFF, BMP)"
                            + " with ",
                    WIDTH,
                    " and ",
                    MAX_HEIGHT,
                    ".")
            .inFiles("file")
            .withStandard("elaphe-like");

    /** Unit of numbers in a file that has none. */
    public static final Setting<HeightUnit> HEIGHT_UNIT = new Setting<>(
            "heightUnit",
            Kinds.alsoWritten(Kinds.word("UNIT", HeightUnit.class), Map.of("\u00b5m", "um", "\u03bcm", "um")),
            "Unit of the heights in a file that does not say it: pm, nm, um, mm or m.");

    /** Numbers of a row in a file that writes all in one. */
    public static final Setting<Integer> COLUMNS = new Setting<>(
            "columns",
            Kinds.integer("N", 1, ScanLimits.LONGEST_SIDE),
            "How many numbers make a row, in a file that does not say it.");

    /** Which channel of a file holds the heights. */
    public static final Setting<String> CHANNEL = new Setting<>(
            "channel",
            Kinds.alsoWritten(Kinds.text("CHANNEL"), Map.of("gray", "grey")),
            "Channel that holds the heights: the name or number that inspect lists, of an image grey, red, green, blue"
                    + " or alpha. Default: of a scan, heights from a sensor before those from a voltage, trace before"
                    + " retrace.");

    /** What is subtracted from the heights. */
    public static final Setting<Levelling> LEVEL = new Setting<>(
                    "level",
                    Kinds.word("KIND", Levelling.class),
                    "What is subtracted from the heights: none, mean (default), plane.")
            .inFiles("levelling");

    /** What turns a file's samples into metres. */
    public static final List<Setting<?>> SCALE = List.of(WIDTH, HEIGHT, MAX_HEIGHT, HEIGHT_UNIT, COLUMNS);

    /** What may be said of a file's heights, in a descriptor or beside an image's name. */
    public static final List<Setting<?>> OF_FILES =
            List.of(WIDTH, HEIGHT, MAX_HEIGHT, HEIGHT_UNIT, COLUMNS, CHANNEL, LEVEL);

    /** All, the surface first. */
    public static final List<Setting<?>> ALL =
            List.of(PATCH, WIDTH, HEIGHT, MAX_HEIGHT, HEIGHT_UNIT, COLUMNS, CHANNEL, LEVEL);

    private PatchSettings() {}

    /** One column or row alone may be as narrow as a nanometre. */
    private static Setting<Double> side(String key, String help) {
        return new Setting<>(key, Kinds.length(1e-9, 0.1), help);
    }
}
