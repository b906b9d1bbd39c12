package sunbeam.app.scene.texture;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import sunbeam.app.files.input.InputException;

/** Reads textures from image files. Their size is looked at before any memory is taken. */
final class ImageTextureReader {
    /** What every OpenGL 3.3 driver of note takes. */
    private static final int LARGEST = 8192;

    private ImageTextureReader() {}

    static BodyTexture read(Path file) {
        if (!Files.exists(file)) {
            throw new InputException("there is no texture " + file + "; name an image file, or one of "
                    + String.join(", ", BodyTextures.names()));
        }
        try (ImageInputStream stream = ImageIO.createImageInputStream(file.toFile())) {
            Iterator<ImageReader> readers =
                    stream == null ? java.util.Collections.emptyIterator() : ImageIO.getImageReaders(stream);
            if (!readers.hasNext()) {
                throw new InputException(
                        "texture " + file + " is no image that Java can read; convert it to PNG or JPEG");
            }
            return read(file, readers.next(), stream);
        } catch (IOException failure) {
            throw new InputException(
                    "texture " + file + " cannot be read (" + failure.getMessage() + "); check the file", failure);
        }
    }

    private static BodyTexture read(Path file, ImageReader reader, ImageInputStream stream) throws IOException {
        try {
            reader.setInput(stream);
            int width = reader.getWidth(0);
            int height = reader.getHeight(0);
            if (width > LARGEST || height > LARGEST) {
                throw new InputException("texture " + file + " has " + width + " x " + height
                        + " pixels; make it at most " + LARGEST + " x " + LARGEST);
            }
            return texels(reader.read(0));
        } catch (IllegalArgumentException | IndexOutOfBoundsException broken) {
            // What the JDK's decoders throw at damaged files.
            throw new InputException(
                    "texture " + file + " is damaged (" + broken.getMessage() + "); export it again", broken);
        } finally {
            reader.dispose();
        }
    }

    /** Any kind of image to sRGB; transparent texels keep their colour and become opaque. */
    private static BodyTexture texels(BufferedImage image) {
        boolean grey = image.getColorModel().getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        return grey && image.getRaster().getTransferType() <= DataBuffer.TYPE_USHORT
                ? greyTexels(image)
                : colorTexels(image);
    }

    /**
     * Java takes grey samples for linear light, but files hold them, like colours, as the sRGB curve gives them; only
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
