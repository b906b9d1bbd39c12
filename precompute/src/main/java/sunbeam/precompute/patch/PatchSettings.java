package sunbeam.precompute.patch;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.scan.text.DecimalMark;
import sunbeam.precompute.setting.Kinds;
import sunbeam.precompute.setting.Setting;

/** Settings of a patch. Their limits refuse nanometers typed for micrometers. */
public final class PatchSettings {
    /** Meters. */
    public static final Setting<Double> WIDTH =
            side("width", "Extent along x of an image, or of a file that does not say it, for example 65um.");

    /** Meters. */
    public static final Setting<Double> HEIGHT =
            side("height", "Extent along y of such a file. Default: square pixels.");

    /** Meters; of 255 for 8 bits, 65535 for 16 bits, 1.0 for floats and numbers without unit. */
    public static final Setting<Double> MAX_HEIGHT = new Setting<>(
            "maxHeight",
            Kinds.length(1e-12, 1),
            "Height of an image's full scale (255, 65535, or 1.0), for example 375nm.");

    public static final Setting<String> PATCH = new Setting<>(
                    "patch",
                    Kinds.text("PATCH"),
                    "The surface: a built-in patch (" + String.join(", ", BuiltInPatches.names()) + "), a"
                            + " descriptor (.json), a scan in its instrument's format, or an image (PNG, TIFF, BMP)"
                            + " with ",
                    WIDTH,
                    " and ",
                    MAX_HEIGHT,
                    ".")
            .inFiles("file")
            .withStandard("elaphe-like");

    public static final Setting<String> HEIGHT_UNIT = new Setting<>(
            "heightUnit",
            Kinds.oneOf("UNIT", List.of("pm", "nm", "um", "mm", "m"), unit -> unit)
                    .alsoWritten(Map.of("\u00b5m", "um", "\u03bcm", "um")),
            "Unit of the heights in a file that does not say it: pm, nm, um, mm or m.");

    public static final Setting<Integer> COLUMNS = new Setting<>(
            "columns",
            Kinds.integer("N", 1, ScanLimits.LONGEST_SIDE),
            "How many numbers make a row, in a file that does not say it.");

    public static final Setting<DecimalMark> DECIMAL_MARK = new Setting<>(
            "decimalMark",
            Kinds.word("MARK", DecimalMark.class),
            "Of a text: point or comma. Default: commas are decimal marks where blanks, tabs or semicolons separate the"
                    + " numbers and none has a point.");

    public static final Setting<String> CHANNEL = new Setting<>(
            "channel",
            Kinds.text("CHANNEL").alsoWritten(Map.of("gray", "grey")),
            "Channel that holds the heights: the name or number that inspect lists, of an image grey, red, green, blue"
                    + " or alpha. Default: of a scan, heights from a sensor before those from a voltage, trace before"
                    + " retrace.");

    public static final Setting<Crop> CROP = new Setting<>(
            "crop",
            Crop.KIND,
            "Use this part of the scan alone, measured from its lower left corner: LEFT:RIGHT,BOTTOM:TOP, for example"
                    + " 5um:25um,0um:10um.");

    public static final Setting<Leveling> LEVEL = new Setting<>(
                    "level",
                    Kinds.word("KIND", Leveling.class),
                    "What is subtracted from the heights: none, mean, plane, rows (the plane, then each row's mean),"
                            + " median-rows, quadratic (tilt and bow). Default: plane for a file, mean for a descriptor"
                            + " and for what is periodic.")
            .inFiles("levelling");

    public static final Setting<Boolean> DESPIKE = new Setting<>(
            "despike",
            Kinds.flag(),
            "Replace single samples that stand far above or below all around them by the median of these; says how many"
                    + " and how high.");

    public static final Setting<Edges> EDGES = new Setting<>(
            "edges",
            Kinds.word("KIND", Edges.class),
            "Where the scan's repetition begins: repeat as it is, or blend opposite borders over a tenth of each side."
                    + " Default: blend for a file, repeat for a descriptor and for what is periodic.");

    public static final Setting<Boolean> PERIODIC = new Setting<>(
            "periodic",
            Kinds.flag(),
            "The patch is a period of the surface (its negation: it is not, whatever it looks like). A scan that is none is"
                    + " seen with a coherence length of at most its shorter side.");

    /** Settings that turn a file's samples into meters. */
    public static final List<Setting<?>> SCALE = List.of(WIDTH, HEIGHT, MAX_HEIGHT, HEIGHT_UNIT, COLUMNS, DECIMAL_MARK);

    /** Settings of the preparation of heights. */
    public static final List<Setting<?>> PREPARING = List.of(CROP, LEVEL, DESPIKE, EDGES, PERIODIC);

    /** Settings of a file, given in its descriptor or together with the file's name. */
    public static final List<Setting<?>> OF_FILES = Stream.of(SCALE, List.<Setting<?>>of(CHANNEL), PREPARING)
            .<Setting<?>>flatMap(List::stream)
            .toList();

    /** All settings, the patch first. */
    public static final List<Setting<?>> ALL =
            Stream.concat(Stream.<Setting<?>>of(PATCH), OF_FILES.stream()).toList();

    private PatchSettings() {}

    /** A single column or row may be as narrow as a nanometer. */
    private static Setting<Double> side(String key, String help) {
        return new Setting<>(key, Kinds.length(1e-9, 0.1), help);
    }
}
