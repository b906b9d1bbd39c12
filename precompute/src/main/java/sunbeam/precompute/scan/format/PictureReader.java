package sunbeam.precompute.scan.format;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.FileImageInputStream;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.text.Text;

/**
 * PNG, TIFF (its first image) and BMP of 8 or 16 bits a sample, TIFF also of floats: samples as stored, without gamma or color
 * management, row 0 on top. Whole numbers are divided by full scale (255 or 65535); a transparent sample is missing. Decoded by the
 * JDK's ImageIO, after sizes and tags are checked: it takes some TIFFs for others without a word.
 */
final class PictureReader {
    private static final List<String> COLORS = List.of("red", "green", "blue");
    private static final int MOST_BANDS = 4;
    private static final int BMP_COMPRESSION = 30;
    private static final int EMBEDDED_JPEG = 4;
    private static final int EMBEDDED_PNG = 5;

    private static final int COMPRESSION = 259;
    private static final int PHOTOMETRIC = 262;
    private static final int ORIENTATION = 274;
    private static final int TILE_WIDTH = 322;
    private static final int TILE_LENGTH = 323;

    /** Kinds of pictures by their first characters, with their names for ImageIO. */
    private static final Map<String, String> KINDS = Map.of(
            "\u0089PNG\r\n\u001a\n", "png",
            "II*\0", "tiff",
            "MM\0*", "tiff",
            "BM", "bmp",
            "\u00ff\u00d8\u00ff", "JPEG",
            "GIF8", "GIF");

    private PictureReader() {}

    private static Optional<String> kind(ScanBytes file) throws IOException {
        String head = file.headText(8);
        return KINDS.keySet().stream().filter(head::startsWith).map(KINDS::get).findFirst();
    }

    static boolean recognises(ScanBytes file) throws IOException {
        return kind(file).isPresent();
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        try {
            return channels(decoded(file, kind(file).orElseThrow()));
        } catch (ScanException told) {
            throw told;
        } catch (IOException | RuntimeException broken) {
            // Image decoders answer damaged files with exceptions of many kinds, unchecked ones among them.
            throw new ScanException(
                    "is damaged or of a kind that cannot be read; export the scan again as PNG or TIFF", broken);
        }
    }

    private static BufferedImage decoded(ScanBytes file, String kind) throws IOException {
        switch (kind) {
            case "tiff" -> requirePlain(TiffPages.read(file, 1).get(0));
            case "bmp" -> requirePlainBmp(file);
            case "png" -> {}
            default ->
                throw new ScanException("is a " + kind + ", which is not exact; export the scan as PNG, TIFF or BMP");
        }
        ImageReader reader = ImageIO.getImageReadersByFormatName(kind).next();
        try (FileImageInputStream in = new FileImageInputStream(file.path().toFile())) {
            reader.setInput(in, true, true);
            long columns = reader.getWidth(0);
            long rows = reader.getHeight(0);
            ScanLimits.requireSize(columns, rows);
            ScanLimits.requireMemory(columns * rows, columns * rows * bytesPerPixel(reader));
            return reader.read(0);
        } finally {
            reader.dispose();
        }
    }

    private static int bytesPerPixel(ImageReader reader) throws IOException {
        Iterator<ImageTypeSpecifier> types = reader.getImageTypes(0);
        if (!types.hasNext()) {
            throw new ScanException("stores its samples in an unknown way; save it as grey 8- or 16-bit PNG");
        }
        SampleModel model = types.next().getSampleModel();
        if (model.getNumBands() > MOST_BANDS) {
            throw new ScanException("has " + model.getNumBands() + " channels; save it as grey or RGB");
        }
        return model.getNumDataElements() * DataBuffer.getDataTypeSize(model.getDataType()) / Byte.SIZE;
    }

    private static void requirePlainBmp(ScanBytes file) throws IOException {
        byte[] head = file.head(BMP_COMPRESSION + 1);
        int compression = head.length > BMP_COMPRESSION ? head[BMP_COMPRESSION] : 0;
        if (compression == EMBEDDED_JPEG || compression == EMBEDDED_PNG) {
            throw new ScanException("is a BMP around another image; save it as PNG or as uncompressed BMP");
        }
    }

    /** Lossless, upright, of samples that are taken for what they are, in tiles of a bounded size. */
    private static void requirePlain(TiffPages.Page page) throws IOException {
        int compression = (int) page.number(COMPRESSION);
        if (compression == 6 || compression == 7) {
            throw new ScanException("has JPEG compression, which falsifies heights; save it with LZW, ZIP or none");
        }
        int meaning = page.has(PHOTOMETRIC) ? (int) page.number(PHOTOMETRIC) : 1;
        if (meaning < 1 || meaning > 3) {
            throw new ScanException("is a TIFF with photometric interpretation " + meaning
                    + "; save it as grey (black is zero) or RGB");
        }
        int orientation = (int) page.number(ORIENTATION);
        if (orientation > 1) {
            throw new ScanException("is a TIFF with orientation tag " + orientation
                    + "; save it upright (row 0 on top, column 0 on the left)");
        }
        int bits = page.has(TiffPages.BITS) ? (int) page.number(TiffPages.BITS) : 1;
        int format = (int) page.number(TiffPages.SAMPLE_FORMAT);
        boolean known = format <= 1 || (format == 2 && bits == 16) || (format == 3 && (bits == 32 || bits == 64));
        if (!known) {
            throw new ScanException("is a TIFF with " + bits + "-bit samples of format " + format
                    + "; save it as 16-bit or 32-bit float");
        }
        double tile = page.number(TILE_WIDTH) * page.number(TILE_LENGTH);
        if (tile > ScanLimits.MOST_SAMPLES) {
            throw new ScanException(Text.format("is a TIFF with tiles of %.0f samples; save it in strips", tile));
        }
    }

    /** Grey of an image whose colors are equal, too; of any other none is known to hold heights. */
    private static List<ScanChannel> channels(BufferedImage image) {
        if (image.getColorModel() instanceof IndexColorModel palette) {
            return channels(palette.convertToIntDiscrete(image.getRaster(), false));
        }
        ColorModel model = image.getColorModel();
        int space = model.getColorSpace().getType();
        int colors = model.getNumColorComponents();
        if (!(space == ColorSpace.TYPE_GRAY && colors == 1) && !(space == ColorSpace.TYPE_RGB && colors == 3)) {
            throw new ScanException("has channels that are neither grey nor RGB; save it as grey or RGB");
        }
        if (model.hasAlpha() && model.isAlphaPremultiplied()) {
            throw new ScanException("stores colors multiplied by alpha; save it without transparency");
        }
        double fullScale = fullScale(image.getSampleModel());
        List<ScanChannel> channels = new ArrayList<>();
        if (colors == 1 || colorsAreEqual(image.getRaster())) {
            channels.add(channel("grey", 0, image, fullScale));
        }
        for (int band = 0; colors == 3 && band < 3; band++) {
            channels.add(channel(COLORS.get(band), band, image, fullScale));
        }
        if (model.hasAlpha()) {
            channels.add(channel("alpha", colors, image, fullScale));
        }
        return channels;
    }

    /** The sample that stands for full scale; 1 of floats. */
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

    private static double[] row(Raster raster, int band, int row) {
        return raster.getSamples(0, row, raster.getWidth(), 1, band, (double[]) null);
    }

    private static boolean colorsAreEqual(Raster raster) {
        return IntStream.range(0, raster.getHeight())
                .allMatch(row -> Arrays.equals(row(raster, 0, row), row(raster, 1, row))
                        && Arrays.equals(row(raster, 0, row), row(raster, 2, row)));
    }

    /** Samples over full scale, NaN where they are transparent. */
    private static ScanChannel channel(String name, int band, BufferedImage image, double fullScale) {
        Raster raster = image.getRaster();
        int columns = raster.getWidth();
        int alpha = image.getColorModel().getNumColorComponents();
        boolean masked = image.getColorModel().hasAlpha() && band != alpha;
        Samples samples = new Samples(columns, raster.getHeight(), () -> {
            double[] read = new double[columns * raster.getHeight()];
            for (int row = 0; row < raster.getHeight(); row++) {
                double[] values = row(raster, band, row);
                double[] opaque = masked ? row(raster, alpha, row) : values;
                for (int column = 0; column < columns; column++) {
                    boolean missing = masked && opaque[column] == 0;
                    read[row * columns + column] = missing ? Double.NaN : values[column] / fullScale;
                }
            }
            return read;
        });
        return new ScanChannel(name, samples, Extent.UNKNOWN, fullScale == 1 ? "" : ScanChannel.FULL_SCALE);
    }
}
