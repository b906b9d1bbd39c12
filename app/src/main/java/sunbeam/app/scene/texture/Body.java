package sunbeam.app.scene.texture;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/**
 * Textures of a mesh. Arrays are shared.
 *
 * @param relief encoded by {@link ScaleRelief}
 * @param directions flow map of the nanostructure's x axis: red along the tangent (right), green along the bitangent (up); the bytes 1, 128
 *     and 255 mean -1, 0 and 1. A height map turned by 180 degrees is another surface
 * @param patches map whose red byte is the index of the patch
 */
public record Body(BodyTexture colors, Scales scales, BodyTexture relief, BodyTexture directions, BodyTexture patches) {
    /** Plain white, the mesh's own tangents, or one patch everywhere. */
    public static final String NONE = "none";

    /** Color of the single patch without a map. */
    public static final int WHITE = 0xffffff;

    private static final int ZERO = 128;
    // Sixteenth of the longest vector, in steps of a byte, which resolve the direction of a shorter one too coarsely.
    private static final int SHORTEST = 8;

    /** Loads the textures; {@code patches} comes from {@link #patches}. Throws InputException if a file cannot be used. */
    public static Body load(
            String texture, Scales scales, String orientationMap, BodyTexture patches, BlobCache cache) {
        BodyTexture colors = BodyTexture.load(texture, cache);
        BodyTexture relief = ScaleRelief.of(scales, cache);
        return new Body(colors, scales, relief, directions(orientationMap), patches);
    }

    private static BodyTexture directions(String nameOrFile) {
        if (nameOrFile.equals(NONE)) {
            return BodyTexture.ofTexel(255, ZERO, ZERO, 255);
        }
        Path file = Path.of(nameOrFile);
        BodyTexture map = BodyTexture.read("orientation map", file, ", or " + NONE);
        boolean gray = true;
        for (int texel = 0; texel < map.width() * map.height(); texel++) {
            int color = map.color(texel);
            int red = color >> 16;
            int green = color >> 8 & 0xff;
            if (Math.hypot(red - ZERO, green - ZERO) < SHORTEST) {
                throw new InputException("orientation map " + file + " has no direction in column "
                        + texel % map.width() + ", row " + texel / map.width() + ": red " + red + " and green " + green
                        + " are nearly " + ZERO + ", which is zero; paint one, (255, 128) for the mesh's own tangent");
            }
            gray &= color == 0x010101 * red;
        }
        if (gray) {
            throw new InputException("orientation map " + file
                    + " is gray; its red and green must be x and y of a direction, as in a flow map");
        }
        return map;
    }

    /**
     * Loads a map of exactly these colors, 0xRRGGBB, and puts their indices in place of its texels.
     *
     * @throws InputException if the file or its colors cannot be used
     */
    public static BodyTexture patches(String nameOrFile, List<Integer> colors) {
        if (nameOrFile.equals(NONE)) {
            return BodyTexture.ofTexel(0, 0, 0, 255);
        }
        Path file = Path.of(nameOrFile);
        BodyTexture map = BodyTexture.read("patch map", file, "");
        Set<Integer> missing = new TreeSet<>(colors);
        int last = -1;
        int index = -1;
        for (int texel = 0; texel < map.width() * map.height(); texel++) {
            int color = map.color(texel);
            index = color == last ? index : colors.indexOf(color);
            last = color;
            if (index < 0) {
                throw new InputException(Text.format(
                        "patch map %s has #%06x in column %d, row %d, which has no patch; known are %s (paint without soft"
                                + " edges, save as PNG)",
                        file, color, texel % map.width(), texel / map.width(), names(new TreeSet<>(colors))));
            }
            missing.remove(color);
            map.rgba()[4 * texel] = (byte) index;
        }
        if (!missing.isEmpty()) {
            throw new InputException("patch map " + file + " has nowhere " + names(missing)
                    + "; paint where that patch is, or leave it out of the scene");
        }
        return map;
    }

    private static String names(Set<Integer> colors) {
        return colors.stream().map(color -> Text.format("#%06x", color)).collect(Collectors.joining(", "));
    }
}
