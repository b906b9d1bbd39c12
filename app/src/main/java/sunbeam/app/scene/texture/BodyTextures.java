package sunbeam.app.scene.texture;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.joml.Vector3dc;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.precompute.color.Srgb;

/** Finds a texture by name or file. */
public final class BodyTextures {
    /** Name of a neutral dark body, on which a nanostructure's colors show. */
    public static final String DARK = "dark";

    private static final int COLUMNS = 4096;
    private static final int ROWS = 512;

    private BodyTextures() {}

    /** Returns the names of the built-in textures, in the order in which help shows them. */
    public static List<String> names() {
        return List.of("elaphe", "xenopeltis", DARK, Body.NONE);
    }

    /**
     * Loads a built-in texture by its name, or a picture from a file.
     *
     * <ul>
     * <li>{@code elaphe}: a corn snake, red saddles with dark edges on orange-brown, a checkered belly
     * <li>{@code xenopeltis}: a sunbeam snake, dark brown with a pale belly
     * <li>{@code dark}: dark gray
     * <li>{@code none}: plain white
     * </ul>
     *
     * @param nameOrFile a name, or an image file in sRGB ({@link sunbeam.app.files.input.ImageFile})
     * @throws sunbeam.precompute.files.InputException if there is no such texture, or the file cannot be used
     */
    public static BodyTexture load(String nameOrFile, BlobCache cache) {
        return switch (nameOrFile) {
            case "elaphe" -> load(nameOrFile, ElapheColors::new, cache);
            case "xenopeltis" -> load(nameOrFile, BodyColors.Xenopeltis::new, cache);
            case DARK -> BodyTexture.ofTexel(0x30, 0x30, 0x32, 255);
            case Body.NONE -> BodyTexture.ofTexel(255, 255, 255, 255);
            default -> BodyTexture.read("texture", Path.of(nameOrFile), ", or one of " + String.join(", ", names()));
        };
    }

    public static boolean isAnimal(String name) {
        return names().contains(name) && !name.equals(Body.NONE) && !name.equals(DARK);
    }

    private static BodyTexture load(String name, Supplier<BodyColors> colors, BlobCache cache) {
        return new BodyTexture(
                COLUMNS, ROWS, cache.get("texture " + name, 4 * COLUMNS * ROWS, () -> paint(colors.get())));
    }

    private static byte[] paint(BodyColors colors) {
        return BodyTexture.opaque(COLUMNS, IntStream.range(0, ROWS).parallel(), ROWS, (column, row) -> {
            Vector3dc color = colors.at((column + 0.5) / COLUMNS, 1 - 2 * (row + 0.5) / ROWS);
            return Srgb.channel(color.x()) << 16 | Srgb.channel(color.y()) << 8 | Srgb.channel(color.z());
        });
    }
}
