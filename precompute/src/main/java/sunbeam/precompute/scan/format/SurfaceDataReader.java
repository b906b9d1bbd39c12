package sunbeam.precompute.scan.format;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.text.TextNumbers;

/**
 * Reader of .sdf files of ISO 25178-71, text ("aISO-1.0") and binary ("bISO-1.0"), and of BCR-1.0. Xscale and Yscale are pitches in meters;
 * a height in meters is sample * Zscale. Missing samples are BAD in text, the lowest integer or NaN in binary files.
 */
final class SurfaceDataReader {
    private static final int BINARY_HEADER_BYTES = 81;
    private static final Map<Integer, SampleType> TYPES = Map.of(
            0, SampleType.UNSIGNED_8,
            1, SampleType.UNSIGNED_16,
            2, SampleType.UNSIGNED_32,
            3, SampleType.FLOAT_32,
            4, SampleType.SIGNED_8,
            5, SampleType.SIGNED_16,
            6, SampleType.SIGNED_32,
            7, SampleType.FLOAT_64);

    private SurfaceDataReader() {}

    static boolean recognizes(ScanBytes file) throws IOException {
        return file.headText(8).matches("[ab](ISO|BCR)-\\d\\.\\d");
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        return List.of(file.startsWith("a") ? text(file) : binary(file));
    }

    private static ScanChannel text(ScanBytes file) throws IOException {
        String head = file.headBefore("*");
        Header values = Header.of(head, '=');
        requireUncompressed((int) values.number("Compression", 0));
        long line = head.lines().count() + 1;
        int columns = values.count("NumPoints");
        int rows = values.count("NumProfiles");
        Samples samples = new Samples(
                columns, rows, () -> numbers(file, head.length() + 1L, line, Math.multiplyExact(columns, rows)));
        return channel(samples, values.number("Xscale"), values.number("Yscale"), values.number("Zscale"));
    }

    private static double[] numbers(ScanBytes file, long offset, long line, int count) throws IOException {
        Reader reader = new InputStreamReader(file.stream(offset), StandardCharsets.ISO_8859_1);
        return TextNumbers.read(new BufferedReader(reader), false, line, count).first(count);
    }

    private static ScanChannel binary(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(8 + 10 + 12 + 12, ByteOrder.LITTLE_ENDIAN);
        int columns = cursor.unsigned16();
        int rows = cursor.unsigned16();
        double pitchX = cursor.float64();
        double pitchY = cursor.float64();
        double scale = cursor.float64();
        cursor.float64();
        requireUncompressed(cursor.unsignedByte());
        SampleType type = SampleType.of(TYPES, cursor.unsignedByte());
        double missing = switch (type) {
            case SIGNED_16 -> Short.MIN_VALUE;
            case SIGNED_32 -> Integer.MIN_VALUE;
            default -> Double.NaN;
        };
        Samples samples =
                Samples.of(file, BINARY_HEADER_BYTES, columns, rows, type).withMissing(missing);
        return channel(samples, pitchX, pitchY, scale);
    }

    private static ScanChannel channel(Samples samples, double pitchX, double pitchY, double scale) {
        Extent extent = Extent.ofPitches(pitchX, pitchY, "m", samples);
        return new ScanChannel("Topography", samples.scale(scale, 0), extent, "m");
    }

    private static void requireUncompressed(int compression) {
        if (compression != 0) {
            throw new ScanException("is compressed, which this reader does not support; export it without compression");
        }
    }
}
