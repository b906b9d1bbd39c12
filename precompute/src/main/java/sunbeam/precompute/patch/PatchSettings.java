package sunbeam.precompute.patch;

import java.util.List;
import java.util.Map;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.TextReader;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;

/** Settings of a patch. Their limits refuse nanometers typed for micrometers. */
public final class PatchSettings {
    /** Meters. */
    public static final Setting<Double> WIDTH = side(
            "width", "Extent along x of an image, or of another file without or with a wrong size, for example 65um.");

    /** Meters. */
    public static final Setting<Double> HEIGHT =
            side("height", "Extent along y of such a file. Default: the file's shape of pixels, else square ones.");

    /** Meters; of 255 for 8 bits, 65535 for 16 bits, 1.0 for floats and numbers without unit. */
    public static final Setting<Double> MAX_HEIGHT = new Setting<>(
            "maxHeight",
            ValueKind.length(1e-12, 1),
            "Height of an image's full scale (255, 65535, or 1.0), for example 375nm.");

    public static final Setting<String> PATCH = new Setting<>(
                    "patch",
                    ValueKind.text("PATCH"),
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
            ValueKind.oneOf("UNIT", List.of("pm", "nm", "um", "mm", "m"), unit -> unit)
                    .alsoWritten(Map.of("\u00b5m", "um", "\u03bcm", "um")),
            "Unit of the heights of a file without one, or with a wrong one: pm, nm, um, mm or m.");

    public static final Setting<Integer> COLUMNS = new Setting<>(
            "columns",
            ValueKind.integer("N", 1, Samples.LONGEST_SIDE),
            "Numbers per row of a file that does not state it.");

    public static final Setting<TextReader.DecimalMark> DECIMAL_MARK = new Setting<>(
            "decimalMark",
            ValueKind.word("MARK", TextReader.DecimalMark.class),
            "Decimal mark of a text file: point or comma. Default: comma if blanks, tabs or semicolons separate the"
                    + " numbers and no number has a point.");

    public static final Setting<String> CHANNEL = new Setting<>(
            "channel",
            ValueKind.text("CHANNEL").alsoWritten(Map.of("gray", "grey")),
            "Channel of the heights: a name or number that inspect lists; for an image grey, red, green, blue or alpha."
                    + " Default for scans: heights from a sensor before heights from a voltage, trace before retrace.");

    public static final Setting<Crop> CROP = new Setting<>(
            "crop",
            Crop.KIND,
            "Part of the scan to use, measured from its lower left corner: LEFT:RIGHT,BOTTOM:TOP, for example"
                    + " 5um:25um,0um:10um.");

    public static final Setting<Leveling> LEVEL = new Setting<>(
                    "level",
                    ValueKind.word("KIND", Leveling.class),
                    "Subtract from the heights: none, mean, plane, rows (the plane, then each row's mean), median-rows,"
                            + " quadratic (tilt and bow). Default: plane for files, mean for descriptors and periodic"
                            + " surfaces.")
            .inFiles("levelling");

    public static final Setting<Boolean> DESPIKE = new Setting<>(
            "despike",
            ValueKind.flag(),
            "Replace spikes, single samples far above or below their surroundings, by the median around them; reports"
                    + " their number and height.");

    public static final Setting<Edges> EDGES = new Setting<>(
            "edges",
            ValueKind.word("KIND", Edges.class),
            "Borders of the repeated scan: repeat them as they are, or blend them over about a tenth of each side,"
                    + " where opposite ones fit best. Default: blend for files, repeat for descriptors and periodic surfaces.");

    public static final Setting<Boolean> PERIODIC = new Setting<>(
            "periodic",
            ValueKind.flag(),
            "The patch is one period of the surface; negated, a piece of it. The coherence length of a piece is at most its"
                    + " shorter side.");

    /** Settings that turn a file's samples into meters. */
    public static final List<Setting<?>> SCALE = List.of(WIDTH, HEIGHT, MAX_HEIGHT, HEIGHT_UNIT, COLUMNS, DECIMAL_MARK);

    public static final List<Setting<?>> PREPARING = List.of(CROP, LEVEL, DESPIKE, EDGES, PERIODIC);

    /** Settings of a file, given in its descriptor or together with the file's name. */
    public static final List<Setting<?>> OF_FILES = Setting.union(SCALE, List.of(CHANNEL), PREPARING);

    public static final List<Setting<?>> ALL = Setting.union(List.of(PATCH), OF_FILES);

    private PatchSettings() {}

    private static Setting<Double> side(String key, String help) {
        return new Setting<>(key, ValueKind.length(1e-9, 1), help);
    }
}
