package sunbeam.precompute.scan;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.FileImageInputStream;

/**
 * Reader of pictures: samples without gamma or color management over full scale (255 for 8 bits, 65535 for 16), row 0 on top; transparent
 * ones are missing. ImageIO decodes PNG and BMP after a check of their size.
 */
final class PictureReader {
    private static final List<String> COLORS = List.of("red", "green", "blue");
    // Four bands of 16 bits.
    private static final int MOST_BYTES_PER_PIXEL = 8;
    // Position of the compression code in a BMP file, bytes.
    private static final int BMP_COMPRESSION = 30;
    private static final int BMP_HEADER = 14;
    private static final int BMP_RESOLUTION = 38;
    // Types of chunks of PNG, IDAT and pHYs.
    private static final int IMAGE_DATA = 0x49444154;
    private static final int PHYSICAL_PIXELS = 0x70485973;
    private static final int EMBEDDED_JPEG = 4;
    private static final int EMBEDDED_PNG = 5;

    /** ImageIO's names of formats by files' first characters. */
    private static final Map<String, String> KINDS = Map.of(
            "\u0089PNG\r\n\u001a\n", "png",
            "II*\0", "tiff",
            "MM\0*", "tiff",
            "II+\0", "tiff",
            "MM\0+", "tiff",
            "BM", "bmp",
            "\u00ff\u00d8\u00ff", "JPEG",
            "GIF8", "GIF");

    private static final int WHITE_IS_ZERO = 0;
    private static final int BLACK_IS_ZERO = 1;
    private static final int PALETTE = 3;
    private static final int PREMULTIPLIED = 1;
    private static final int ALPHA = 2;
    // Bits of the tag NewSubfileType for a reduced copy and for a mask.
    private static final int NO_IMAGE = 1 | 4;

    private PictureReader() {}

    static Optional<String> kind(ScanBytes file) throws IOException {
        return KINDS.keySet().stream()
                .filter(file.headText(8)::startsWith)
                .map(KINDS::get)
                .findFirst();
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        try {
            String kind = kind(file).orElseThrow();
            return kind.equals("tiff") ? tiff(file) : channels(decoded(file, kind), resolution(file, kind));
        } catch (ScanException refused) {
            throw refused;
        } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError | AssertionError broken) {
            // Decoders throw many kinds of exceptions and errors.
            throw new ScanException(
                    "is damaged or of a kind that cannot be read; export the scan again as PNG or TIFF", broken);
        }
    }

    private static BufferedImage decoded(ScanBytes file, String kind) throws IOException {
        ScanException.refuseIf(
                !kind.equals("png") && !kind.equals("bmp"),
                "is a " + kind + ", which is not exact; export the scan as PNG, TIFF or BMP");
        byte[] head = file.head(BMP_COMPRESSION + 1);
        int compression = kind.equals("bmp") && head.length > BMP_COMPRESSION ? head[BMP_COMPRESSION] : 0;
        ScanException.refuseIf(
                compression == EMBEDDED_JPEG || compression == EMBEDDED_PNG,
                "is a BMP around another image; save it as PNG or as uncompressed BMP");
        ImageReader reader = ImageIO.getImageReadersByFormatName(kind).next();
        try (FileImageInputStream in = new FileImageInputStream(file.path().toFile())) {
            reader.setInput(in, true, true);
            long columns = reader.getWidth(0);
            long rows = reader.getHeight(0);
            Samples.requireSize(columns, rows);
            Samples.requireMemory(columns * rows, columns * rows * MOST_BYTES_PER_PIXEL);
            return reader.read(0);
        } finally {
            reader.dispose();
        }
    }

    /**
     * Returns samples per length along x and y, of which only the ratio counts; zeros if there are none. Source: W3C, "PNG", chunk pHYs;
     * Microsoft, "BITMAPINFOHEADER".
     */
    private static long[] resolution(ScanBytes file, String kind) throws IOException {
        if (kind.equals("bmp")) {
            boolean hasResolution =
                    file.cursor(BMP_HEADER, ByteOrder.LITTLE_ENDIAN).unsigned32() >= BMP_COMPRESSION;
            ScanBytes.Cursor at = file.cursor(BMP_RESOLUTION, ByteOrder.LITTLE_ENDIAN);
            return hasResolution ? new long[] {at.int32(), at.int32()} : new long[2];
        }
        ScanBytes.Cursor chunk = file.cursor(8, ByteOrder.BIG_ENDIAN);
        while (true) {
            long length = chunk.unsigned32();
            int type = chunk.int32();
            if (type == IMAGE_DATA) {
                return new long[2];
            }
            if (type == PHYSICAL_PIXELS) {
                return new long[] {chunk.unsigned32(), chunk.unsigned32()};
            }
            chunk.skip(length + Integer.BYTES);
        }
    }

    private static List<ScanChannel> channels(BufferedImage image, long[] resolution) throws IOException {
        if (image.getColorModel() instanceof IndexColorModel palette) {
            // With colors that are opaque or transparent alone, Java's default gives alpha one bit.
            return channels(palette.convertToIntDiscrete(image.getRaster(), palette.hasAlpha()), resolution);
        }
        ColorModel model = image.getColorModel();
        int space = model.getColorSpace().getType();
        int colors = model.getNumColorComponents();
        if (!(space == ColorSpace.TYPE_GRAY && colors == 1) && !(space == ColorSpace.TYPE_RGB && colors == 3)) {
            throw new ScanException("has channels that are neither gray nor RGB; save it as gray or RGB");
        }
        double fullScale = fullScale(image.getSampleModel());
        List<Samples> bands = IntStream.range(0, colors)
                .mapToObj(band -> band(image.getRaster(), band, fullScale))
                .toList();
        Optional<Samples> alpha =
                model.hasAlpha() ? Optional.of(band(image.getRaster(), colors, fullScale)) : Optional.empty();
        boolean resolved = resolution[0] > 0 && resolution[1] > 0;
        Extent extent = resolved
                ? Extent.ofPitches(1.0 / resolution[0], 1.0 / resolution[1], "", bands.get(0))
                : Extent.UNKNOWN;
        return channels("", bands, alpha, extent, ScanChannel.FULL_SCALE);
    }

    private static double fullScale(SampleModel model) {
        int[] bits = Arrays.stream(model.getSampleSize()).distinct().toArray();
        if (bits.length > 1 || (bits[0] != 8 && bits[0] != 16)) {
            throw new ScanException("has " + (bits.length > 1 ? "different numbers of" : bits[0])
                    + " bits per sample; save it with 8 or 16 bits or as 32-bit float TIFF");
        }
        return Math.pow(2, bits[0]) - 1;
    }

    private static Samples band(Raster raster, int band, double fullScale) {
        int columns = raster.getWidth();
        int rows = raster.getHeight();
        return new Samples(
                        columns, rows, () -> raster.getSamples(0, 0, columns, rows, band, new double[columns * rows]))
                .scale(1 / fullScale, 0);
    }

    /** Returns gray, of one band or three equal ones; red, green and blue; alpha. Samples are missing where alpha is 0. */
    private static List<ScanChannel> channels(
            String prefix, List<Samples> colors, Optional<Samples> alpha, Extent extent, String unit)
            throws IOException {
        List<ScanChannel> channels = new ArrayList<>();
        double[] first = colors.size() == 1 ? new double[0] : colors.get(0).read();
        if (colors.size() == 1
                || (Arrays.equals(first, colors.get(1).read())
                        && Arrays.equals(first, colors.get(2).read()))) {
            channels.add(new ScanChannel(prefix + "grey", withoutTransparent(colors.get(0), alpha), extent, unit));
        }
        for (int color = 0; colors.size() == 3 && color < 3; color++) {
            Samples band = withoutTransparent(colors.get(color), alpha);
            channels.add(new ScanChannel(prefix + COLORS.get(color), band, extent, unit));
        }
        alpha.ifPresent(band -> channels.add(new ScanChannel(prefix + "alpha", band, extent, unit)));
        return channels;
    }

    private static Samples withoutTransparent(Samples color, Optional<Samples> alpha) {
        Samples.Source opaque = () -> {
            double[] samples = color.read();
            double[] opacity = alpha.orElseThrow().read();
            Arrays.setAll(samples, i -> opacity[i] == 0 ? Double.NaN : samples[i]);
            return samples;
        };
        return alpha.isEmpty() ? color : new Samples(color.columns(), color.rows(), opaque);
    }

    /**
     * Reads TIFF pictures: gray, RGB or with a palette, integers or floats. Each page has its own channels; reduced copies and masks are
     * skipped.
     */
    private static List<ScanChannel> tiff(ScanBytes file) throws IOException {
        List<TiffPage> all = TiffPage.read(file);
        List<TiffPage> images = all.stream()
                .filter(page -> ((int) page.number(TIFF.TAG_SUBFILE_TYPE, 0) & NO_IMAGE) == 0)
                .toList();
        List<TiffPage> pages = images.isEmpty() ? all.subList(0, 1) : images;
        TiffScale scale = TiffScale.of(all.get(0));
        List<ScanChannel> channels = new ArrayList<>(tiffPage(pages.get(0), scale, pages.size() > 1));
        for (TiffPage page : pages.subList(1, pages.size())) {
            try {
                channels.addAll(tiffPage(page, scale, true));
            } catch (ScanException unreadable) {
                // Such as a preview; the others may do.
            }
        }
        return channels;
    }

    private static List<ScanChannel> tiffPage(TiffPage page, TiffScale scale, boolean several) throws IOException {
        int interpretation = (int) page.number(TIFF.TAG_PHOTOMETRIC_INTERPRETATION, BLACK_IS_ZERO);
        ScanException.refuseIf(
                interpretation < WHITE_IS_ZERO || interpretation > PALETTE,
                "is a TIFF with photometric interpretation " + interpretation + "; save it as gray or RGB");
        int extra = (int) page.number(TIFF.TAG_EXTRA_SAMPLES, 0);
        ScanException.refuseIf(
                interpretation > BLACK_IS_ZERO && TiffScale.gdal(page).isPresent(),
                "has GDAL's scale, offset or unit for a color; export the band of heights alone");
        ScanException.refuseIf(
                extra == PREMULTIPLIED, "stores colors multiplied by alpha; save it without transparency");
        double fullScale = page.isFloat() ? 1 : Math.pow(2, page.bits()) - 1;
        double sign = interpretation == WHITE_IS_ZERO ? -1 : 1;
        List<Samples> bands = new ArrayList<>();
        for (int band = 0; band < page.bands(); band++) {
            Samples samples = page.samples(band);
            if (interpretation == PALETTE && band == 0) {
                bands.addAll(palette(samples, page.numbers(TIFF.TAG_COLOR_MAP)));
            } else {
                bands.add(samples.scale(sign / fullScale, interpretation == WHITE_IS_ZERO ? 1 : 0));
            }
        }
        int colors = interpretation > BLACK_IS_ZERO ? 3 : 1;
        if (bands.size() < colors) {
            throw new ScanException("has " + bands.size() + " channels where 3 colors are announced; export it again");
        }
        Optional<Samples> alpha = bands.stream().skip(colors).findFirst().filter(band -> extra == ALPHA);
        String prefix = several ? "page " + (page.index() + 1) + " " : "";
        String ofSamples = page.isFloat() ? "" : ScanChannel.FULL_SCALE;
        Extent extent = scale.extent(page, bands.get(0));
        Optional<TiffScale.Calibration> calibration = colors == 1 ? scale.calibration(page) : Optional.empty();
        if (calibration.isEmpty()) {
            return channels(prefix, bands.subList(0, colors), alpha, extent, ofSamples);
        }
        ScanException.refuseIf(
                sign < 0, "has calibrated samples whose white is 0; save it with an upright scale of grays");
        double span = fullScale * calibration.get().factor();
        Samples values = bands.get(0).scale(span, calibration.get().offset());
        return channels(
                        prefix,
                        List.of(values),
                        alpha,
                        extent,
                        calibration.get().unit())
                .stream()
                .map(channel -> channel.calibrated(
                        page.isFloat() ? channel.span() : span,
                        calibration.get().note()))
                .toList();
    }

    /** Palettes have 16 bits; some programs write 8. */
    private static List<Samples> palette(Samples indices, double[] palette) {
        int length = palette.length / 3;
        double fullScale = Arrays.stream(palette).max().orElse(0) > 255 ? 65_535 : 255;
        return IntStream.range(0, 3)
                .mapToObj(color -> indices.map(
                        index -> index < length ? palette[color * length + (int) index] / fullScale : Double.NaN))
                .toList();
    }
}
