package sunbeam.precompute.scan.format;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.SampleModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/** The channels of a decoded image: grey or RGB, with or without alpha, or a palette of these. */
final class ImageBands {
    private static final int PALETTE_BANDS = 4;

    private final BufferedImage image;
    private final boolean color;
    private final boolean alpha;
    /** Of each index red, green, blue and alpha; null without a palette. */
    private final byte[][] palette;

    /** The sample that stands for full scale; 1 of floats. */
    private final double fullScale;

    ImageBands(BufferedImage image) {
        this.image = image;
        ColorModel model = image.getColorModel();
        alpha = model.hasAlpha();
        palette = model instanceof IndexColorModel indexed ? palette(indexed) : null;
        color = palette != null || isColor(model);
        fullScale = palette != null ? 255 : fullScale(image.getSampleModel());
        if (alpha && model.isAlphaPremultiplied() && hasVeiledSamples()) {
            throw new ScanException("stores colors multiplied by alpha; save it without transparency");
        }
    }

    private static byte[][] palette(IndexColorModel model) {
        byte[][] values = new byte[PALETTE_BANDS][model.getMapSize()];
        model.getReds(values[0]);
        model.getGreens(values[1]);
        model.getBlues(values[2]);
        model.getAlphas(values[3]);
        return values;
    }

    private static boolean isColor(ColorModel model) {
        int space = model.getColorSpace().getType();
        int channels = model.getNumColorComponents();
        if (!(space == ColorSpace.TYPE_GRAY && channels == 1) && !(space == ColorSpace.TYPE_RGB && channels == 3)) {
            throw new ScanException("has channels that are neither grey nor RGB; save it as grey or RGB");
        }
        return channels == 3;
    }

    private static double fullScale(SampleModel model) {
        int type = model.getDataType();
        if (type == DataBuffer.TYPE_FLOAT || type == DataBuffer.TYPE_DOUBLE) {
            return 1;
        }
        int bits = model.getSampleSize(0);
        for (int band = 1; band < model.getNumBands(); band++) {
            bits = model.getSampleSize(band) == bits ? bits : -1;
        }
        if (bits != 8 && bits != 16) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %s bits per sample; save it with 8 or 16 bits or as 32-bit float TIFF",
                    bits < 0 ? "different numbers of" : Integer.toString(bits)));
        }
        return Math.pow(2, bits) - 1;
    }

    private int alphaBand() {
        return color ? 3 : 1;
    }

    /** One row of a band, as stored. */
    private double[] row(int band, int row, double[] target) {
        double[] read = image.getRaster().getSamples(0, row, image.getWidth(), 1, palette == null ? band : 0, target);
        for (int column = 0; palette != null && column < read.length; column++) {
            read[column] = palette[band][(int) read[column]] & 0xff;
        }
        return read;
    }

    private boolean hasVeiledSamples() {
        for (int row = 0; row < image.getHeight(); row++) {
            for (double value : row(alphaBand(), row, null)) {
                if (value != 0 && value != fullScale) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean colorsAreEqual() {
        for (int row = 0; row < image.getHeight(); row++) {
            double[] red = row(0, row, null);
            if (!Arrays.equals(red, row(1, row, null)) || !Arrays.equals(red, row(2, row, null))) {
                return false;
            }
        }
        return true;
    }

    /** Grey of an image whose colors are equal, too; of any other none is known to hold heights. */
    List<ScanChannel> channels() {
        List<ScanChannel> channels = new ArrayList<>();
        if (!color || colorsAreEqual()) {
            channels.add(channel("grey", 0));
        }
        for (int band = 0; color && band < 3; band++) {
            channels.add(channel(List.of("red", "green", "blue").get(band), band));
        }
        if (alpha) {
            channels.add(channel("alpha", alphaBand()));
        }
        return channels;
    }

    private ScanChannel channel(String name, int band) {
        String unit = fullScale == 1 ? "" : ScanChannel.FULL_SCALE;
        return new ScanChannel(name, image.getWidth(), image.getHeight(), Extent.UNKNOWN, unit, () -> samples(band));
    }

    private double[] samples(int band) {
        int columns = image.getWidth();
        double[] samples = new double[columns * image.getHeight()];
        double[] values = new double[columns];
        double[] opaque = new double[columns];
        boolean masked = alpha && band != alphaBand();
        for (int row = 0; row < image.getHeight(); row++) {
            row(band, row, values);
            if (masked) {
                row(alphaBand(), row, opaque);
            }
            for (int column = 0; column < columns; column++) {
                boolean missing = masked && opaque[column] == 0;
                samples[row * columns + column] = missing ? Double.NaN : values[column] / fullScale;
            }
        }
        return samples;
    }
}
