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
    /** The name of no texture: plain white. */
    public static final String NONE = "none";

    /** The name of a neutral dark body, on which a nanostructure's colors show. */
    public static final String DARK = "dark";

    private static final byte[] DARK_GREY = {0x30, 0x30, 0x32, -1};

    private static final int LENGTH = 4096;
    private static final int GIRTH = 512;

    private BodyTextures() {}

    /** The built-in textures, in the order in which help shows them. */
    public static List<String> names() {
        return List.of("elaphe", "xenopeltis", DARK, NONE);
    }

    /**
     * A built-in texture by its name, or a picture from a file.
     *
     * <ul>
     * <li>{@code elaphe}: a corn snake, red saddles with dark edges on orange-brown, a checkered belly
     * <li>{@code xenopeltis}: a sunbeam snake, dark brown with a pale belly
     * <li>{@code dark}: dark gray
     * <li>{@code none}: plain white
     * </ul>
     *
     * @param nameOrFile a name, or an image file (PNG, JPEG, BMP, GIF) in sRGB
     * @param kept cache of the animals' textures
     * @throws sunbeam.app.files.input.InputException if it is neither, or the file cannot be used
     */
    public static BodyTexture load(String nameOrFile, BlobCache kept) {
        return switch (nameOrFile) {
            case "elaphe" -> painted(nameOrFile, ElapheColors::new, kept);
            case "xenopeltis" -> painted(nameOrFile, XenopeltisColors::new, kept);
            case DARK -> new BodyTexture(1, 1, DARK_GREY.clone());
            case NONE -> new BodyTexture(1, 1, new byte[] {-1, -1, -1, -1});
            default -> ImageTextureReader.read(Path.of(nameOrFile));
        };
    }

    /** True if the texture is an animal's body. */
    public static boolean isAnimal(String name) {
        return names().contains(name) && !name.equals(NONE) && !name.equals(DARK);
    }

    private static BodyTexture painted(String name, Supplier<BodyColors> colors, BlobCache kept) {
        return new BodyTexture(
                LENGTH, GIRTH, kept.get("texture " + name, 4 * LENGTH * GIRTH, () -> paint(colors.get())));
    }

    /** Paints a texture: u along the body, v around it, from belly to belly. */
    private static byte[] paint(BodyColors colors) {
        byte[] rgba = new byte[4 * LENGTH * GIRTH];
        IntStream.range(0, GIRTH).parallel().forEach(row -> {
            double around = 1 - 2 * (row + 0.5) / GIRTH;
            for (int column = 0; column < LENGTH; column++) {
                Vector3dc color = colors.at((column + 0.5) / LENGTH, around);
                int texel = 4 * (row * LENGTH + column);
                rgba[texel] = (byte) Srgb.channel(color.x());
                rgba[texel + 1] = (byte) Srgb.channel(color.y());
                rgba[texel + 2] = (byte) Srgb.channel(color.z());
                rgba[texel + 3] = -1;
            }
        });
        return rgba;
    }
}
