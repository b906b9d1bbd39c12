package sunbeam.app.scene.texture;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import sunbeam.app.files.input.InputException;

/**
 * Reads textures from image files: PNG, JPEG, BMP, GIF and TIFF, told apart by their first bytes. Their size is looked at
 * before any memory is taken.
 */
final class ImageTextureReader {
    /** What every OpenGL 3.3 driver of note takes. */
    private static final int LARGEST = 8192;
    /** Names of the JDK's readers. Others, which a Java may bring along, nobody has tried on damaged files. */
    private static final Set<String> FORMATS = Set.of("png", "jpeg", "bmp", "gif", "tif");
    /** The decoder's own rows, then RGBA, then what OpenGL is given. */
    private static final int BYTES_PER_TEXEL = 12;

    private ImageTextureReader() {}

    static BodyTexture read(Path file) {
        return read(file, Runtime.getRuntime().maxMemory());
    }

    /** @param heapBytes largest size of the heap */
    static BodyTexture read(Path file, long heapBytes) {
        if (!Files.exists(file)) {
            throw new InputException("there is no texture " + file + "; name an image file, or one of "
                    + String.join(", ", BodyTextures.names()));
        }
        InputException.requireRegular(file);
        try (ImageInputStream stream = new FileImageInputStream(file.toFile())) {
            return read(file, reader(file, stream), stream, heapBytes);
        } catch (IOException failure) {
            throw new InputException(
                    "texture " + file + " cannot be read (" + failure.getMessage() + "); check the file", failure);
        }
    }

    private static ImageReader reader(Path file, ImageInputStream stream) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            if (FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
                return reader;
            }
        }
        throw new InputException("texture " + file + " is no PNG, JPEG, BMP, GIF or TIFF; convert it to PNG or JPEG");
    }

    private static BodyTexture read(Path file, ImageReader reader, ImageInputStream stream, long heapBytes)
            throws IOException {
        try {
            reader.setInput(stream, true, true);
            requireSize(file, reader, heapBytes);
            return texels(reader.read(0));
        } catch (InputException refused) {
            throw refused;
        } catch (RuntimeException broken) {
            // Image decoders answer damaged files with exceptions of many kinds.
            String reason = broken.getMessage() == null ? broken.getClass().getSimpleName() : broken.getMessage();
            throw new InputException("texture " + file + " is damaged (" + reason + "); export it again", broken);
        } finally {
            reader.dispose();
        }
    }

    private static void requireSize(Path file, ImageReader reader, long heapBytes) throws IOException {
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        if (width < 1 || height < 1 || width > LARGEST || height > LARGEST) {
            throw new InputException("texture " + file + " has " + width + " x " + height + " pixels; make it at most "
                    + LARGEST + " x " + LARGEST);
        }
        // A file whose tiles are larger than its picture makes its reader take memory for a tile.
        long texels = Math.max((long) width * height, (long) reader.getTileWidth(0) * reader.getTileHeight(0));
        if (texels > (long) LARGEST * LARGEST) {
            throw new InputException("texture " + file + " has tiles of " + reader.getTileWidth(0) + " x "
                    + reader.getTileHeight(0) + " pixels; save it without tiles");
        }
        Iterator<ImageTypeSpecifier> types = reader.getImageTypes(0);
        if (!types.hasNext()) {
            throw new InputException("texture " + file + " has pixels of an unknown kind; convert it to PNG or JPEG");
        }
        SampleModel model = types.next().getSampleModel();
        long bytesPerTexel =
                (long) model.getNumDataElements() * DataBuffer.getDataTypeSize(model.getDataType()) / Byte.SIZE
                        + BYTES_PER_TEXEL;
        if (texels > heapBytes / bytesPerTexel) {
            throw new InputException("texture " + file + " has " + width + " x " + height
                    + " pixels, too many for Java's memory; make it smaller, or give more with"
                    + " SUNBEAM_JAVA_OPTIONS=-Xmx" + 2 * (heapBytes >> 20) + "m");
        }
    }

    /** Any kind of image to sRGB; transparent texels keep their color and become opaque. */
    private static BodyTexture texels(BufferedImage image) {
        boolean grey = image.getColorModel().getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        return grey && image.getRaster().getTransferType() <= DataBuffer.TYPE_USHORT
                ? greyTexels(image)
                : colorTexels(image);
    }

    /**
     * Java takes grey samples for linear light, but files hold them, like colors, as the sRGB curve gives them; only
     * samples of more than 16 bits, floats above all, are linear in files too.
     */
    private static BodyTexture greyTexels(BufferedImage image) {
        Raster samples = image.getRaster();
        int white = (1 << samples.getSampleModel().getSampleSize(0)) - 1;
        byte[] rgba = new byte[4 * image.getWidth() * image.getHeight()];
        for (int texel = 0; texel < rgba.length / 4; texel++) {
            int sample = samples.getSample(texel % image.getWidth(), texel / image.getWidth(), 0);
            byte grey = (byte) Math.round(255f * sample / white);
            Arrays.fill(rgba, 4 * texel, 4 * texel + 3, grey);
            rgba[4 * texel + 3] = -1;
        }
        return new BodyTexture(image.getWidth(), image.getHeight(), rgba);
    }

    private static BodyTexture colorTexels(BufferedImage image) {
        int width = image.getWidth();
        int height = image.getHeight();
        byte[] rgba = new byte[4 * width * height];
        for (int row = 0; row < height; row++) {
            int[] line = image.getRGB(0, row, width, 1, null, 0, width);
            for (int column = 0; column < width; column++) {
                int texel = 4 * (row * width + column);
                rgba[texel] = (byte) (line[column] >> 16);
                rgba[texel + 1] = (byte) (line[column] >> 8);
                rgba[texel + 2] = (byte) line[column];
                rgba[texel + 3] = -1;
            }
        }
        return new BodyTexture(width, height, rgba);
    }
}
