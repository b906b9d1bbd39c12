package sunbeam.precompute.scan.format;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.FileImageInputStream;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/**
 * PNG, TIFF (its first image) and BMP of 8 or 16 bits a sample, TIFF also of floats: samples as stored, without gamma or color
 * management, row 0 on top. Whole numbers are divided by full scale (255 or 65535); a transparent sample is missing. Decoded by the
 * JDK's ImageIO, after sizes and tags are checked: it takes some TIFFs for others without a word.
 */
final class PictureReader {
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
            return new ImageBands(decoded(file, kind(file).orElseThrow())).channels();
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
            throw new ScanException(
                    String.format(Locale.ROOT, "is a TIFF with tiles of %.0f samples; save it in strips", tile));
        }
    }
}
