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
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/** The channels of a decoded image: grey or RGB, with or without alpha, or a palette of these. */
final class ImageBands {
    private static final List<String> COLORS = List.of("red", "green", "blue");
    /** Of a color as {@link BufferedImage#getRGB} has it: red, green, blue, alpha. */
    private static final int[] SHIFTS = {16, 8, 0, 24};

    private final BufferedImage image;
    private final boolean palette;
    private final boolean color;
    private final boolean alpha;

    /** The sample that stands for full scale; 1 of floats. */
    private final double fullScale;

    /** @throws ScanException when it is neither grey nor RGB, or has samples of an odd width */
    ImageBands(BufferedImage image) {
        this.image = image;
        ColorModel model = image.getColorModel();
        alpha = model.hasAlpha();
        palette = model instanceof IndexColorModel;
        color = palette || isColor(model);
        fullScale = palette ? 255 : fullScale(image.getSampleModel());
        if (alpha && model.isAlphaPremultiplied()) {
            throw new ScanException("stores colors multiplied by alpha; save it without transparency");
        }
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
        int[] bits = Arrays.stream(model.getSampleSize()).distinct().toArray();
        if (bits.length > 1 || (bits[0] != 8 && bits[0] != 16)) {
            throw new ScanException("has " + (bits.length > 1 ? "different numbers of" : bits[0])
                    + " bits per sample; save it with 8 or 16 bits or as 32-bit float TIFF");
        }
        return Math.pow(2, bits[0]) - 1;
    }

    private int alphaBand() {
        return color ? 3 : 1;
    }

    /** One row of a band, as stored. */
    private double[] row(int band, int row) {
        if (!palette) {
            return image.getRaster().getSamples(0, row, image.getWidth(), 1, band, (double[]) null);
        }
        return Arrays.stream(image.getRGB(0, row, image.getWidth(), 1, null, 0, image.getWidth()))
                .mapToDouble(argb -> argb >> SHIFTS[band] & 0xff)
                .toArray();
    }

    private boolean colorsAreEqual() {
        for (int row = 0; row < image.getHeight(); row++) {
            double[] red = row(0, row);
            if (!Arrays.equals(red, row(1, row)) || !Arrays.equals(red, row(2, row))) {
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
            channels.add(channel(COLORS.get(band), band));
        }
        if (alpha) {
            channels.add(channel("alpha", alphaBand()));
        }
        return channels;
    }

    private ScanChannel channel(String name, int band) {
        String unit = fullScale == 1 ? "" : ScanChannel.FULL_SCALE;
        Samples samples = new Samples(image.getWidth(), image.getHeight(), () -> samples(band));
        return new ScanChannel(name, samples, Extent.UNKNOWN, unit);
    }

    /** Of full scale, NaN where they are transparent. */
    private double[] samples(int band) {
        int columns = image.getWidth();
        double[] samples = new double[columns * image.getHeight()];
        boolean masked = alpha && band != alphaBand();
        for (int row = 0; row < image.getHeight(); row++) {
            double[] values = row(band, row);
            double[] opaque = masked ? row(alphaBand(), row) : values;
            for (int column = 0; column < columns; column++) {
                boolean missing = masked && opaque[column] == 0;
                samples[row * columns + column] = missing ? Double.NaN : values[column] / fullScale;
            }
        }
        return samples;
    }
}
