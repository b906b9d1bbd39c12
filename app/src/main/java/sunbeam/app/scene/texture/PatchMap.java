package sunbeam.app.scene.texture;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Text;

/** Map of the patches on a mesh's texture: an image with one exact color for each patch. */
public final class PatchMap {
    /** Name of one patch everywhere instead of a map. */
    public static final String NONE = "none";

    /** Color of the single patch if there is no map, 0xRRGGBB. */
    public static final int WHITE = 0xffffff;

    private PatchMap() {}

    /**
     * Loads a map, and checks its colors.
     *
     * @param nameOrFile {@link #NONE} or an image file
     * @param colors colors that the map must have, and no others, 0xRRGGBB
     * @throws InputException if the file cannot be used, or its colors are not exactly these
     */
    public static BodyTexture load(String nameOrFile, Set<Integer> colors) {
        if (nameOrFile.equals(NONE)) {
            return new BodyTexture(1, 1, new byte[] {-1, -1, -1, -1});
        }
        Path file = Path.of(nameOrFile);
        if (!Files.exists(file)) {
            throw new InputException("there is no patch map " + file + "; name an image file");
        }
        BodyTexture map = ImageTextureReader.read(file);
        Set<Integer> missing = new TreeSet<>(colors);
        int last = -1;
        for (int texel = 0; texel < map.width() * map.height(); texel++) {
            int color = color(map, texel);
            if (color != last) {
                if (!colors.contains(color)) {
                    throw new InputException(Text.format(
                            "patch map %s has #%06x in column %d, row %d, which has no patch; known are %s (paint without soft"
                                    + " edges, save as PNG)",
                            file, color, texel % map.width(), texel / map.width(), names(colors)));
                }
                missing.remove(color);
                last = color;
            }
        }
        if (!missing.isEmpty()) {
            throw new InputException("patch map " + file + " has nowhere " + names(missing)
                    + "; paint where that patch is, or leave it out of the scene");
        }
        return map;
    }

    private static int color(BodyTexture map, int texel) {
        byte[] rgba = map.rgba();
        return (rgba[4 * texel] & 0xff) << 16 | (rgba[4 * texel + 1] & 0xff) << 8 | (rgba[4 * texel + 2] & 0xff);
    }

    private static String names(Set<Integer> colors) {
        return colors.stream().map(color -> Text.format("#%06x", color)).collect(Collectors.joining(", "));
    }
}
