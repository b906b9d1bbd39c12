package sunbeam.app.scene.texture;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.files.input.InputException;

/** Reads textures from image files. */
final class ImageTextureReader {
    /**
     * Limits: the largest side that common OpenGL 3.3 drivers support, and 4 bytes per pixel each for decoded rows, RGBA and the upload.
     */
    private static final ImageFile IMAGE_FILE = new ImageFile("texture", 8192, 8192 * 8192, 12);

    private ImageTextureReader() {}

    static BodyTexture read(Path file) {
        return read(file, Runtime.getRuntime().maxMemory());
    }

    static BodyTexture read(Path file, long heapBytes) {
        if (!Files.exists(file)) {
            throw new InputException("there is no texture " + file + "; name an image file, or one of "
                    + String.join(", ", BodyTextures.names()));
        }
        return texels(IMAGE_FILE.read(file, heapBytes));
    }

    /** Transparent texels keep their color and become opaque. */
    private static BodyTexture texels(BufferedImage image) {
        boolean gray = image.getColorModel().getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        return gray && image.getRaster().getTransferType() <= DataBuffer.TYPE_USHORT
                ? grayTexels(image)
                : colorTexels(image);
    }

    /**
     * Converts gray samples. Java takes them for linear light, but in files they follow the sRGB curve; only samples of more than 16 bits,
     * such as floats, are linear.
     */
    private static BodyTexture grayTexels(BufferedImage image) {
        Raster samples = image.getRaster();
        int white = (1 << samples.getSampleModel().getSampleSize(0)) - 1;
        byte[] rgba = new byte[4 * image.getWidth() * image.getHeight()];
        for (int texel = 0; texel < rgba.length / 4; texel++) {
            int sample = samples.getSample(texel % image.getWidth(), texel / image.getWidth(), 0);
            byte gray = (byte) Math.round(255f * sample / white);
            Arrays.fill(rgba, 4 * texel, 4 * texel + 3, gray);
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
