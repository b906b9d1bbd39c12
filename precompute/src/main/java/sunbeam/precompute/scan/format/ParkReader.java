package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Park Systems' TIFF: a picture for everybody, and in private tags the samples, from the bottom row, with a header. A
 * height is {@code gain (scale sample + offset)}. Source: Park Systems, "TIFF format for XEI", and files.
 */
final class ParkReader {
    private static final int MAGIC = 50432;
    private static final int VERSION = 50433;
    private static final int DATA = 50434;
    private static final int HEADER = 50435;
    /** Value of the first of these tags. */
    private static final int PARK = 0x0e031301;

    private static final int FIRST_VERSION_WITH_TYPES = 0x01000002;
    private static final Map<Integer, SampleType> TYPES =
            Map.of(0, SampleType.SIGNED_16, 1, SampleType.SIGNED_32, 2, SampleType.FLOAT_32);

    private ParkReader() {}

    static boolean recognises(ScanBytes file) throws IOException {
        return TiffPages.has(file, 1, MAGIC) && TiffPages.has(file, 1, HEADER);
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        TiffPages.Page page = TiffPages.read(file, 1).get(0);
        if (page.number(MAGIC) != PARK || !page.has(DATA)) {
            throw new ScanException("has no heights in its Park Systems tags; export it again");
        }
        long start = page.position(HEADER);
        ByteCursor header = file.cursor(start, ByteOrder.LITTLE_ENDIAN);
        if (header.int32() != 0) {
            throw new ScanException("holds lines or spectra and no scan; choose the file of the image");
        }
        int columns = header.at(start + 100).int32();
        int rows = header.int32();
        boolean forward = header.at(start + 128).int32() != 0;
        double width = 1e-6 * header.at(start + 140).float64();
        double height = 1e-6 * header.float64();
        double gain = header.at(start + 220).float64();
        double scale = header.float64();
        double offset = gain * header.float64();
        boolean typed = page.number(VERSION) >= FIRST_VERSION_WITH_TYPES;
        SampleType type = SampleType.of(TYPES, typed ? header.at(start + 348).int32() : 0);
        Samples samples = Samples.of(file, page.position(DATA), columns, rows, type);
        if (samples.count() * type.size() > page.bytes(DATA)) {
            throw new ScanException("has " + page.bytes(DATA) + " bytes of samples where " + columns + " x " + rows
                    + " take " + samples.count() * type.size() + "; copy or export it again");
        }
        return List.of(new ScanChannel(
                wide(file, start + 4, 32),
                !forward,
                samples.upsideDown().scaled(scale == 0 ? gain : gain * scale, offset),
                Extent.of(width, height),
                wide(file, start + 244, 8)));
    }

    /** Text of 16-bit characters up to a NUL. */
    private static String wide(ScanBytes file, long position, int characters) throws IOException {
        byte[] bytes = file.read(position, 2 * characters).array();
        String text = new String(bytes, StandardCharsets.UTF_16LE);
        int end = text.indexOf(0);
        return end < 0 ? text : text.substring(0, end);
    }
}
