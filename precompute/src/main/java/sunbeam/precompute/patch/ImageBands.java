package sunbeam.precompute.patch;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentSampleModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The channels of a decoded image as the file stores them, without gamma or colour management. The indices of a palette
 * image are replaced by the colours they stand for, so a palette of greys in order, or in any other, gives the greys.
 */
final class ImageBands {
    private final Raster raster;
    private final SampleFormat format;
    private final boolean colour;
    private final boolean alpha;
    private final boolean premultiplied;
    /** For palette images the values of red, green, blue and alpha of each index, else null. */
    private final byte[][] palette;

    /** @throws PatchException when the image is neither grey nor RGB or its samples have no known full scale */
    ImageBands(Path file, BufferedImage image) {
        ColorModel model = image.getColorModel();
        raster = image.getRaster();
        alpha = model.hasAlpha();
        premultiplied = alpha && model.isAlphaPremultiplied();
        if (model instanceof IndexColorModel indexed) {
            palette = palette(indexed);
            colour = true;
            format = SampleFormat.UNSIGNED_8;
        } else {
            palette = null;
            colour = isColour(file, model);
            format = format(file, raster.getSampleModel());
        }
    }

    private static byte[][] palette(IndexColorModel model) {
        byte[][] values = new byte[4][model.getMapSize()];
        model.getReds(values[0]);
        model.getGreens(values[1]);
        model.getBlues(values[2]);
        model.getAlphas(values[3]);
        return values;
    }

    private static boolean isColour(Path file, ColorModel model) {
        int space = model.getColorSpace().getType();
        int channels = model.getNumComponents() - (model.hasAlpha() ? 1 : 0);
        if (space == ColorSpace.TYPE_GRAY && channels == 1) {
            return false;
        }
        if (space == ColorSpace.TYPE_RGB && channels == 3) {
            return true;
        }
        throw new PatchException(String.format(
                Locale.ROOT,
                "%s has %d channels that are neither grey nor RGB; save it as grey or RGB",
                file,
                model.getNumComponents()));
    }

    private static SampleFormat format(Path file, SampleModel model) {
        int type = model.getDataType();
        if (type == DataBuffer.TYPE_FLOAT || type == DataBuffer.TYPE_DOUBLE) {
            return SampleFormat.FLOAT;
        }
        int bits = model.getSampleSize(0);
        for (int band = 1; band < model.getNumBands(); band++) {
            bits = model.getSampleSize(band) == bits ? bits : -1;
        }
        if (bits == 8) {
            return SampleFormat.UNSIGNED_8;
        }
        if (bits == 16) {
            return type == DataBuffer.TYPE_SHORT ? SampleFormat.SIGNED_16 : SampleFormat.UNSIGNED_16;
        }
        throw new PatchException(String.format(
                Locale.ROOT,
                "%s has %s bits per sample; save it with 8 or 16 bits or as 32-bit float TIFF",
                file,
                bits < 0 ? "different numbers of" : Integer.toString(bits)));
    }

    SampleFormat format() {
        return format;
    }

    int columns() {
        return raster.getWidth();
    }

    int rows() {
        return raster.getHeight();
    }

    boolean isColour() {
        return colour;
    }

    boolean hasAlpha() {
        return alpha;
    }

    /** Whether colours are stored multiplied by alpha. */
    boolean isPremultiplied() {
        return premultiplied;
    }

    /** "8-bit RGBA", "16-bit grey", "8-bit palette". */
    String description() {
        String kind =
                palette != null ? "palette" : (colour ? "RGB" : "grey") + (alpha ? (colour ? "A" : " and alpha") : "");
        return format.label() + " " + kind;
    }

    /** Index of the alpha band. */
    int alphaBand() {
        return colour ? 3 : 1;
    }

    /**
     * One row of a band.
     *
     * @param band 0 for grey or red, 1 for green, 2 for blue, {@link #alphaBand()} for alpha
     * @param row from the top
     * @param target at least as long as a row; overwritten
     */
    void read(int band, int row, double[] target) {
        if (palette == null) {
            readStored(band, row, target);
            return;
        }
        readStored(0, row, target);
        for (int column = 0; column < columns(); column++) {
            target[column] = palette[band][(int) target[column]] & 0xff;
        }
    }

    private void readStored(int band, int row, double[] target) {
        int x = raster.getMinX();
        int y = raster.getMinY() + row;
        if (!(raster.getSampleModel() instanceof ComponentSampleModel model)) {
            raster.getSamples(x, y, columns(), 1, band, target);
            return;
        }
        // What Raster.getSamples does, in a third of its time.
        DataBuffer stored = raster.getDataBuffer();
        int bank = model.getBankIndices()[band];
        int index = model.getOffset(x - raster.getSampleModelTranslateX(), y - raster.getSampleModelTranslateY(), band);
        for (int column = 0; column < columns(); column++) {
            target[column] = stored.getElemDouble(bank, index);
            index += model.getPixelStride();
        }
    }
}
