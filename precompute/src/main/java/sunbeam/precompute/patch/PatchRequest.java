package sunbeam.precompute.patch;

import java.util.Optional;
import java.util.function.Function;

/**
 * What a user asks for with {@code --patch} and the options that go with it.
 *
 * @param patch a built-in name, a descriptor (*.json) or an image
 * @param width {@code --width}: extent along x, metres
 * @param extent {@code --height}: extent along y, metres
 * @param maxHeight {@code --max-height}: height of full scale, metres
 * @param channel {@code --channel}: which channel of the image holds the heights
 * @param levelling {@code --level}: what is subtracted from the heights
 */
public record PatchRequest(
        String patch,
        Optional<Double> width,
        Optional<Double> extent,
        Optional<Double> maxHeight,
        Optional<Channel> channel,
        Optional<Levelling> levelling) {
    /** The least extent along x or y, metres: one column or row alone may be this narrow. */
    public static final double SHORTEST_SIDE = PatchScale.SHORTEST_SIDE;

    /** The largest extent along x or y, metres. */
    public static final double LONGEST_SIDE = PatchScale.LONGEST_SIDE;

    /** The least height of full scale, metres. */
    public static final double SMALLEST_MAX_HEIGHT = PatchScale.SMALLEST_MAX_HEIGHT;

    static final String WIDTH = "--width";
    static final String EXTENT = "--height";
    static final String MAX_HEIGHT = "--max-height";
    static final String CHANNEL = "--channel";
    static final String LEVEL = "--level";

    /** A request with nothing but the patch's name. */
    public static PatchRequest of(String patch) {
        return parse(patch, null, null, null, null, null);
    }

    /**
     * A request from the command line's words; null stands for an option that was not given.
     *
     * @throws PatchException when a word cannot be understood, naming its option
     */
    public static PatchRequest parse(
            String patch, String width, String extent, String maxHeight, String channel, String levelling) {
        return new PatchRequest(
                patch,
                length(WIDTH, width),
                length(EXTENT, extent),
                length(MAX_HEIGHT, maxHeight),
                word(CHANNEL, channel, Channel::parse),
                word(LEVEL, levelling, Levelling::parse));
    }

    private static Optional<Double> length(String option, String text) {
        return Optional.ofNullable(text)
                .map(given -> NamedLength.parse(option, given).metres());
    }

    private static <T> Optional<T> word(String option, String text, Function<String, T> parse) {
        try {
            return Optional.ofNullable(text).map(parse);
        } catch (IllegalArgumentException e) {
            throw new PatchException(option + ": " + e.getMessage(), e);
        }
    }

    /** The width with its option's name. */
    Optional<NamedLength> namedWidth() {
        return width.map(metres -> new NamedLength(WIDTH, metres));
    }

    /** The extent along y with its option's name. */
    Optional<NamedLength> namedExtent() {
        return extent.map(metres -> new NamedLength(EXTENT, metres));
    }

    /** The height of full scale with its option's name. */
    Optional<NamedLength> namedMaxHeight() {
        return maxHeight.map(metres -> new NamedLength(MAX_HEIGHT, metres));
    }

    /**
     * Refuses a scale for a patch that brings its own.
     *
     * @param what the patch that has a scale, for the message
     */
    void requireNoScale(String what) {
        String option =
                width.isPresent() ? WIDTH : extent.isPresent() ? EXTENT : maxHeight.isPresent() ? MAX_HEIGHT : null;
        if (option != null) {
            throw new PatchException("%s contradicts %s, which has its own scale; leave %s out, or name an image"
                    .formatted(option, what, option));
        }
    }
}
