package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.Direction;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * Park Systems' TIFF: a picture for everybody, and in private tags the samples, from the bottom row, with a header. A
 * height is {@code gain (scale sample + offset)}. Source: Park Systems, "TIFF format for XEI", and files.
 */
final class ParkReader implements ScanReader {
    private static final int MAGIC = 50432;
    private static final int VERSION = 50433;
    private static final int DATA = 50434;
    private static final int HEADER = 50435;
    /** Value of the first of these tags. */
    private static final int PARK = 0x0e031301;

    private static final int FIRST_VERSION_WITH_TYPES = 0x01000002;
    private static final int NAME = 4;
    private static final int SIZE = 100;
    private static final int FORWARD = 128;
    private static final int EXTENT = 140;
    private static final int GAIN = 220;
    private static final int UNIT = 244;
    private static final int TYPE = 348;

    @Override
    public String format() {
        return "Park Systems TIFF";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return TiffPages.firstHas(file, MAGIC) && TiffPages.firstHas(file, HEADER);
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        TiffPages.Page page = TiffPages.read(file, 1).get(0);
        if (page.number(MAGIC) != PARK || !page.has(DATA)) {
            throw new ScanException("has no heights in its Park Systems tags; export it again");
        }
        long header = page.position(HEADER);
        ByteCursor cursor = file.cursor(header, ByteOrder.LITTLE_ENDIAN);
        if (cursor.int32() != 0) {
            throw new ScanException("holds lines or spectra and no scan; choose the file of the image");
        }
        cursor.moveTo(header + SIZE);
        int columns = cursor.int32();
        int rows = cursor.int32();
        cursor.moveTo(header + FORWARD);
        boolean forward = cursor.int32() != 0;
        cursor.moveTo(header + EXTENT);
        double width = 1e-6 * cursor.float64();
        double height = 1e-6 * cursor.float64();
        cursor.moveTo(header + GAIN);
        double gain = cursor.float64();
        double scale = cursor.float64();
        double offset = gain * cursor.float64();
        double factor = scale == 0 ? gain : gain * scale;
        SampleType type = type(page, cursor, header);
        SampleBlock block = new SampleBlock(page.position(DATA), (long) columns * rows, type, ByteOrder.LITTLE_ENDIAN)
                .requireIn(file);
        if (block.bytes() > page.bytes(DATA)) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %d bytes of samples where %d x %d take %d; copy or export it again",
                    page.bytes(DATA),
                    columns,
                    rows,
                    block.bytes()));
        }
        return List.of(new ScanChannel(
                wide(file, header + NAME, 32),
                forward ? Direction.TRACE : Direction.RETRACE,
                columns,
                rows,
                Extent.of(width, height),
                wide(file, header + UNIT, 8),
                SampleBlock.of(file, block.offset(), block.count(), type, block.order())
                        .upsideDown(columns)
                        .scaled(factor, offset)));
    }

    private static SampleType type(TiffPages.Page page, ByteCursor cursor, long header) throws IOException {
        if (page.number(VERSION) < FIRST_VERSION_WITH_TYPES) {
            return SampleType.SIGNED_16;
        }
        cursor.moveTo(header + TYPE);
        int code = cursor.int32();
        return switch (code) {
            case 0 -> SampleType.SIGNED_16;
            case 1 -> SampleType.SIGNED_32;
            case 2 -> SampleType.FLOAT_32;
            default ->
                throw new ScanException(
                        String.format(Locale.ROOT, "stores samples of the unknown type %d; export it again", code));
        };
    }

    /** Text of 16-bit characters up to a NUL. */
    private static String wide(ScanBytes file, long position, int characters) throws IOException {
        byte[] bytes = file.read(position, 2 * characters).array();
        String text = new String(bytes, StandardCharsets.UTF_16LE);
        int end = text.indexOf(0);
        return end < 0 ? text : text.substring(0, end);
    }
}
