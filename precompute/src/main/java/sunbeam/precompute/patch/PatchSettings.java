package sunbeam.precompute.patch;

import java.util.List;
import java.util.Map;
import sunbeam.precompute.setting.Kinds;
import sunbeam.precompute.setting.Setting;

/**
 * What a user chooses of a patch. The limits are wide enough for every surface that the model can say something about, and
 * narrow enough to catch nanometres typed for micrometres.
 */
public final class PatchSettings {
    /** Extent of an image along x, metres. */
    public static final Setting<Double> WIDTH = side("width", "Extent of an image along x, for example 65um.");

    /** Extent of an image along y, metres. */
    public static final Setting<Double> HEIGHT = side("height", "Extent of an image along y. Default: square pixels.");

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
                            + " descriptor (.json), or an image (PNG, TIFF, BMP) with ",
                    WIDTH,
                    " and ",
                    MAX_HEIGHT,
                    ".")
            .inFiles("file")
            .withStandard("elaphe-like");

    /** Which channel of an image holds the heights. */
    public static final Setting<Channel> CHANNEL = new Setting<>(
            "channel",
            Kinds.alsoWritten(Kinds.word("CHANNEL", Channel.class), Map.of("gray", "grey")),
            "Channel of an image that holds the heights: grey, red, green, blue, alpha.");

    /** What is subtracted from the heights. */
    public static final Setting<Levelling> LEVEL = new Setting<>(
                    "level",
                    Kinds.word("KIND", Levelling.class),
                    "What is subtracted from the heights: none, mean (default), plane.")
            .inFiles("levelling");

    /** What turns an image's samples into metres. */
    public static final List<Setting<?>> SCALE = List.of(WIDTH, HEIGHT, MAX_HEIGHT);

    /** What may be said of a file's heights, in a descriptor or beside an image's name. */
    public static final List<Setting<?>> OF_FILES = List.of(WIDTH, HEIGHT, MAX_HEIGHT, CHANNEL, LEVEL);

    /** All, the surface first. */
    public static final List<Setting<?>> ALL = List.of(PATCH, WIDTH, HEIGHT, MAX_HEIGHT, CHANNEL, LEVEL);

    private PatchSettings() {}

    /** One column or row alone may be as narrow as a nanometre. */
    private static Setting<Double> side(String key, String help) {
        return new Setting<>(key, Kinds.length(1e-9, 0.1), help);
    }
}
