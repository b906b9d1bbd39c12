package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.List;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of .sur files by Digital Surf (MountainsMap): a header of 512 bytes, a comment, integers from the top row. Source of all offsets:
 * Digital Surf, "SURF file format".
 */
final class DigitalSurfReader {
    private static final int HEADER_LENGTH = 512;
    /** Others are profiles, binary images and series. */
    private static final int SURFACE = 2;

    /** Distance of the value of missing samples below the header's minimum. */
    private static final int BELOW_LOWEST = 2;

    private static final int TEXT_LENGTH = 16;

    private DigitalSurfReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        if (file.startsWith("DSCOMPRESSED")) {
            throw new ScanException("is compressed in a way of its own; save it without compression");
        }
        ScanBytes.Cursor header = file.cursor(0, ByteOrder.LITTLE_ENDIAN);
        int objects = header.at(14).unsigned16();
        int kind = header.at(18).unsigned16();
        if (objects != 1 || kind != SURFACE) {
            throw new ScanException("holds " + objects + " objects of type " + kind
                    + " and no single surface; export the surface alone");
        }
        boolean hasMissing = header.at(86).unsigned16() == 1;
        SampleType type = SampleType.signed(header.at(98).unsigned16());
        double missing = hasMissing ? (double) header.int32() - BELOW_LOWEST : Double.NaN;
        int columns = header.at(108).int32();
        int rows = header.int32();
        double pitchX = header.at(120).float32();
        double pitchY = header.float32();
        double step = header.float32();
        String name = header.at(164).text(TEXT_LENGTH);
        String unitX = header.text(TEXT_LENGTH);
        String unitY = header.text(TEXT_LENGTH);
        String unitZ = header.text(TEXT_LENGTH);
        int inversion = header.at(290).unsigned16();
        long start = HEADER_LENGTH + header.at(334).unsigned16() + (long) header.unsigned16();
        Samples stored =
                undoInversion(Samples.of(file, start, columns, rows, type).withMissing(missing), inversion);
        double metersY =
                Extent.metersPer(unitY).orElse(1.0) / Extent.metersPer(unitX).orElse(1.0);
        return List.of(new ScanChannel(
                name,
                stored.scale(inversion == 0 ? step : -step, 0),
                Extent.ofPitches(pitchX, pitchY * metersY, unitX, stored),
                unitZ));
    }

    /** Undoes the inversion of columns (code 2) or rows (3); heights are inverted too for codes 1 to 3. */
    private static Samples undoInversion(Samples samples, int inversion) {
        return switch (inversion) {
            case 0, 1 -> samples;
            case 2 -> samples.flipColumns();
            case 3 -> samples.flipRows();
            default -> throw new ScanException("is turned over in the unknown way " + inversion + "; export it again");
        };
    }
}
