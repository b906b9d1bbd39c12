package sunbeam.precompute.scan.format;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/**
 * Reader of Park Systems' TIFF files: a preview whose private tags hold a header and the samples, from the bottom row. A height is {@code
 * gain (scale sample + offset)}. Source: Park Systems, "TIFF format for XEI", and sample files.
 */
final class ParkReader {
    private static final int MAGIC = 50432;
    private static final int VERSION = 50433;
    private static final int DATA = 50434;
    private static final int HEADER = 50435;
    private static final int PARK = 0x0e031301;

    /** Bytes; the last field that is read ends there. */
    private static final int LEAST_HEADER = 352;

    private static final int FIRST_VERSION_WITH_TYPES = 0x01000002;
    private static final Map<Integer, SampleType> TYPES =
            Map.of(0, SampleType.SIGNED_16, 1, SampleType.SIGNED_32, 2, SampleType.FLOAT_32);

    private ParkReader() {}

    static boolean recognizes(ScanBytes file) throws IOException {
        return TiffPage.has(file, 1, MAGIC) && TiffPage.has(file, 1, HEADER);
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        TiffPage page = TiffPage.read(file).get(0);
        byte[] data = page.bytes(DATA);
        byte[] head = page.bytes(HEADER);
        ByteBuffer header = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN);
        if (page.number(MAGIC, 0) != PARK || data.length == 0 || head.length < LEAST_HEADER) {
            throw new ScanException("has no heights in its Park Systems tags; export it again");
        }
        if (header.getInt(0) != 0) {
            throw new ScanException("holds lines or spectra and no scan; choose the file of the image");
        }
        int columns = header.getInt(100);
        int rows = header.getInt(104);
        boolean forward = header.getInt(128) != 0;
        double gain = header.getDouble(220);
        double scale = header.getDouble(228);
        double offset = gain * header.getDouble(236);
        boolean typed = page.number(VERSION, 0) >= FIRST_VERSION_WITH_TYPES;
        SampleType type = SampleType.of(TYPES, typed ? header.getInt(348) : 0);
        ScanLimits.requireSize(columns, rows);
        int count = columns * rows;
        if ((long) count * type.size() > data.length) {
            throw new ScanException("has " + data.length + " bytes of samples where " + columns + " x " + rows
                    + " take " + (long) count * type.size() + "; copy or export it again");
        }
        Samples samples = new Samples(
                columns, rows, () -> type.read(new ByteArrayInputStream(data), count, ByteOrder.LITTLE_ENDIAN));
        return List.of(new ScanChannel(
                utf16(head, 4, 32),
                !forward,
                samples.flipRows().scale(scale == 0 ? gain : gain * scale, offset),
                Extent.of(1e-6 * header.getDouble(140), 1e-6 * header.getDouble(148)),
                utf16(head, 244, 8)));
    }

    private static String utf16(byte[] header, int position, int characters) {
        String text = new String(header, position, 2 * characters, StandardCharsets.UTF_16LE);
        int end = text.indexOf(0);
        return end < 0 ? text : text.substring(0, end);
    }
}
