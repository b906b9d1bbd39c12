package sunbeam.app.scene.texture;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntBinaryOperator;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.joml.Vector3dc;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.scene.texture.BodyColors.SnakeHead;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.files.InputException;

/**
 * Picture for a mesh, sRGB, which repeats: left edge u = 0, bottom v = 0.
 *
 * @param rgba {@code 4 * width * height} bytes, red first, row 0 on top; shared. Where colors are transparent there is no nanostructure
 */
public record BodyTexture(int width, int height, byte[] rgba) {
    /** Neutral dark body, on which diffraction shows. */
    public static final String DARK = "dark";

    private static final int COLUMNS = 4096;
    // For colors that differ from scale to scale.
    private static final int FINE_COLUMNS = 8192;
    private static final int ROWS = 512;
    // Limit of common OpenGL 3.3 drivers.
    private static final int LARGEST_SIDE = 8192;
    // 4 bytes each for decoded rows, RGBA and the upload.
    private static final int BYTES_PER_PIXEL = 12;

    public static List<String> names() {
        return List.of("elaphe", "xenopeltis", DARK, Body.NONE);
    }

    /** Loads a built-in texture or a picture; throws InputException if there is none, or the file cannot be used. */
    public static BodyTexture load(String nameOrFile, BlobCache cache) {
        return switch (nameOrFile) {
            case "elaphe" -> load(nameOrFile, FINE_COLUMNS, BodyColors.Elaphe::new, cache);
            case "xenopeltis" -> load(nameOrFile, COLUMNS, BodyColors.Xenopeltis::new, cache);
            case DARK -> ofTexel(0x30, 0x30, 0x32, 255);
            case Body.NONE -> ofTexel(255, 255, 255, 255);
            default -> read("texture", Path.of(nameOrFile), ", or one of " + String.join(", ", names()));
        };
    }

    public static boolean isAnimal(String name) {
        return names().contains(name) && !name.equals(Body.NONE) && !name.equals(DARK);
    }

    private static BodyTexture load(String name, int columns, Supplier<BodyColors> colors, BlobCache cache) {
        return new BodyTexture(
                columns, ROWS, cache.get("colors of " + name, 4 * columns * ROWS, () -> paint(columns, colors.get())));
    }

    private static byte[] paint(int columns, BodyColors colors) {
        byte[] rgba = new byte[4 * columns * ROWS];
        CornerMeans.paint(
                columns,
                ROWS,
                (column, row) -> {
                    Vector3dc color = colors.at((double) column / columns, 1 - 2.0 * row / ROWS);
                    return new double[] {color.x(), color.y(), color.z()};
                },
                (column, row, mean) -> {
                    int at = 4 * (row * columns + column);
                    for (int c = 0; c < 3; c++) {
                        rgba[at + c] = (byte) Srgb.channel(mean[c]);
                    }
                    double along = (column + 0.5) / columns;
                    rgba[at + 3] = (byte) (SnakeHead.isEye(along, 1 - 2 * (row + 0.5) / ROWS) ? 0 : 255);
                });
        return rgba;
    }

    static BodyTexture ofTexel(int red, int green, int blue, int alpha) {
        return new BodyTexture(1, 1, new byte[] {(byte) red, (byte) green, (byte) blue, (byte) alpha});
    }

    /** Returns opaque texels of colors 0xRRGGBB by column and row. */
    static byte[] opaque(int width, IntStream rows, int height, IntBinaryOperator rgb) {
        byte[] rgba = new byte[4 * width * height];
        rows.forEach(row -> {
            for (int column = 0; column < width; column++) {
                int color = rgb.applyAsInt(column, row);
                int texel = 4 * (row * width + column);
                rgba[texel] = (byte) (color >> 16);
                rgba[texel + 1] = (byte) (color >> 8);
                rgba[texel + 2] = (byte) color;
                rgba[texel + 3] = -1;
            }
        });
        return rgba;
    }

    public int color(int texel) {
        return (rgba[4 * texel] & 0xff) << 16 | (rgba[4 * texel + 1] & 0xff) << 8 | (rgba[4 * texel + 2] & 0xff);
    }

    /**
     * Reads an image file. Transparent texels keep their color and become opaque.
     *
     * @param alternative end of the message about a missing file
     * @throws InputException if the file is missing or cannot be used
     */
    static BodyTexture read(String what, Path file, String alternative) {
        return read(what, file, alternative, Runtime.getRuntime().maxMemory());
    }

    static BodyTexture read(String what, Path file, String alternative, long heapBytes) {
        InputException.refuseIf(
                !Files.exists(file), "there is no " + what + " " + file + "; name an image file" + alternative);
        BufferedImage image =
                new ImageFile(what, LARGEST_SIDE, LARGEST_SIDE * LARGEST_SIDE, BYTES_PER_PIXEL).read(file, heapBytes);
        int width = image.getWidth();
        int height = image.getHeight();
        try {
            return new BodyTexture(width, height, opaque(width, IntStream.range(0, height), height, colors(image)));
        } catch (RuntimeException broken) {
            throw new InputException(
                    what + " " + file + " has colors of an unknown kind (" + broken + "); save it as RGB of 8 bits",
                    broken);
        }
    }

    /** Java takes gray samples for linear light, but in files they follow the sRGB curve; only those of more than 16 bits are linear. */
    private static IntBinaryOperator colors(BufferedImage image) {
        Raster samples = image.getRaster();
        ColorModel model = image.getColorModel();
        if (model.getColorSpace().getType() != ColorSpace.TYPE_GRAY) {
            return image::getRGB;
        }
        if (samples.getTransferType() > DataBuffer.TYPE_USHORT) {
            // Java's own conversion fails for samples outside of 0 to 1; Srgb clips them.
            return (column, row) -> 0x010101
                    * Srgb.channel(
                            model.getNormalizedComponents(samples.getDataElements(column, row, null), null, 0)[0]);
        }
        int white = (1 << samples.getSampleModel().getSampleSize(0)) - 1;
        return (column, row) -> 0x010101 * Math.round(255f * samples.getSample(column, row, 0) / white);
    }
}
