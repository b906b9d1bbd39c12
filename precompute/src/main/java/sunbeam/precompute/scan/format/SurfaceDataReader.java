package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.NumberStream;

/**
 * ISO 25178-71 .sdf, as text ("aISO-1.0") and binary ("bISO-1.0"), and its predecessor BCR-1.0. Scales are metres; a
 * height is the sample times Zscale. BAD in text, the lowest integer or NaN in binary files mark missing samples.
 */
final class SurfaceDataReader implements ScanReader {
    private static final int LARGEST_HEADER = 4096;
    private static final int BINARY_HEADER = 81;

    @Override
    public String format() {
        return "ISO 25178-71 (.sdf)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        String magic = file.headText(8);
        return magic.matches("[ab](ISO|BCR)-\\d\\.\\d");
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        return List.of(file.startsWith("a") ? text(file) : binary(file));
    }

    private static ScanChannel text(ScanBytes file) throws IOException {
        String head = file.headText(LARGEST_HEADER);
        int end = head.indexOf('*');
        if (end < 0) {
            throw new ScanException("has no * after its header; copy or export it again");
        }
        Header values = Header.of(head.substring(0, end), '=');
        int columns = values.count("NumPoints");
        int rows = values.count("NumProfiles");
        requirePlain((int) values.number("Compression", 0));
        double scale = values.number("Zscale");
        long lines = head.substring(0, end).lines().count() + 1;
        long offset = end + 1L;
        long count = (long) columns * rows;
        return new ScanChannel(
                "Topography",
                columns,
                rows,
                extent(values.number("Xscale"), values.number("Yscale"), columns, rows),
                "m",
                source(file, offset, count, lines).scaled(scale, 0));
    }

    private static ScanChannel.Source source(ScanBytes file, long offset, long count, long line) {
        return () -> new NumberStream(
                        new InputStreamReader(file.stream(offset), StandardCharsets.ISO_8859_1), false, line)
                .read(count);
    }

    private static ScanChannel binary(ScanBytes file) throws IOException {
        ByteCursor cursor = file.cursor(8 + 10 + 12 + 12, ByteOrder.LITTLE_ENDIAN);
        int columns = cursor.unsigned16();
        int rows = cursor.unsigned16();
        double pitchX = cursor.float64();
        double pitchY = cursor.float64();
        double scale = cursor.float64();
        cursor.float64();
        requirePlain(cursor.unsignedByte());
        SampleType type = type(cursor.unsignedByte());
        ScanChannel.Source samples =
                SampleBlock.of(file, BINARY_HEADER, (long) columns * rows, type, ByteOrder.LITTLE_ENDIAN);
        double missing = switch (type) {
            case SIGNED_16 -> Short.MIN_VALUE;
            case SIGNED_32 -> Integer.MIN_VALUE;
            default -> Double.NaN;
        };
        return new ScanChannel(
                "Topography",
                columns,
                rows,
                extent(pitchX, pitchY, columns, rows),
                "m",
                samples.withMissing(missing).scaled(scale, 0));
    }

    private static Extent extent(double pitchX, double pitchY, int columns, int rows) {
        return Extent.ofPitches(pitchX, pitchY, "m", Math.max(1, columns), Math.max(1, rows));
    }

    private static void requirePlain(int compression) {
        if (compression != 0) {
            throw new ScanException("is compressed in a way of its own; export it without compression");
        }
    }

    private static SampleType type(int code) {
        return switch (code) {
            case 0 -> SampleType.UNSIGNED_8;
            case 1 -> SampleType.UNSIGNED_16;
            case 2 -> SampleType.UNSIGNED_32;
            case 3 -> SampleType.FLOAT_32;
            case 4 -> SampleType.SIGNED_8;
            case 5 -> SampleType.SIGNED_16;
            case 6 -> SampleType.SIGNED_32;
            case 7 -> SampleType.FLOAT_64;
            default ->
                throw new ScanException(
                        String.format(Locale.ROOT, "stores samples of the unknown type %d; export it again", code));
        };
    }
}
