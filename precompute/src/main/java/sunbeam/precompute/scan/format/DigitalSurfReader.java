package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * Digital Surf .sur (MountainsMap): a header of 512 bytes with spacings and their units, a comment, then 16- or 32-bit
 * integers from the top row. Source: Digital Surf, "SURF file format".
 */
final class DigitalSurfReader implements ScanReader {
    private static final int HEADER = 512;
    private static final int OBJECTS = 14;
    private static final int TYPE = 18;
    private static final int SPECIAL_POINTS = 86;
    private static final int BITS = 98;
    private static final int NAME_Z = 164;
    private static final int INVERSION = 290;
    private static final int COMMENT_SIZE = 334;
    /** A surface; others are profiles, binary images and series. */
    private static final int SURFACE = 2;

    /** Where a sample was not measured it is this much below the lowest. */
    private static final int BELOW_LOWEST = 2;

    private static final int UNIT = 16;

    @Override
    public String format() {
        return "Digital Surf (.sur)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith("DIGITAL SURF") || file.startsWith("DSCOMPRESSED");
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        if (file.startsWith("DSCOMPRESSED")) {
            throw new ScanException("is compressed in a way of its own; save it without compression");
        }
        ByteCursor cursor = file.cursor(OBJECTS, ByteOrder.LITTLE_ENDIAN);
        int objects = cursor.unsigned16();
        cursor.moveTo(TYPE);
        int type = cursor.unsigned16();
        if (objects != 1 || type != SURFACE) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "holds %d objects of type %d and no single surface; export the surface alone",
                    objects,
                    type));
        }
        cursor.moveTo(SPECIAL_POINTS);
        boolean special = cursor.unsigned16() == 1;
        cursor.moveTo(BITS);
        SampleType samples = SampleType.signed(cursor.unsigned16());
        int lowest = cursor.int32();
        cursor.skip(Integer.BYTES);
        int columns = cursor.int32();
        int rows = cursor.int32();
        cursor.skip(Integer.BYTES);
        double pitchX = cursor.float32();
        double pitchY = cursor.float32();
        double step = cursor.float32();
        cursor.moveTo(NAME_Z);
        String name = cursor.text(UNIT);
        String unitX = micro(cursor.text(UNIT));
        String unitY = micro(cursor.text(UNIT));
        String unitZ = micro(cursor.text(UNIT));
        cursor.moveTo(INVERSION);
        Inversion inversion = Inversion.of(cursor.unsigned16());
        cursor.moveTo(COMMENT_SIZE);
        long start = HEADER + cursor.unsigned16() + (long) cursor.unsigned16();
        ScanChannel.Source stored =
                SampleBlock.of(file, start, (long) columns * rows, samples, ByteOrder.LITTLE_ENDIAN);
        double missing = special ? (double) lowest - BELOW_LOWEST : Double.NaN;
        double factor = inversion == Inversion.NONE ? step : -step;
        return List.of(new ScanChannel(
                name,
                columns,
                rows,
                extent(pitchX, unitX, pitchY, unitY, columns, rows),
                unitZ,
                inversion.undone(stored.withMissing(missing), columns).scaled(factor, 0)));
    }

    /** What was turned over before the file was written; all of it turns heights over, too. */
    private enum Inversion {
        NONE,
        HEIGHTS,
        COLUMNS,
        ROWS;

        static Inversion of(int code) {
            if (code >= values().length) {
                throw new ScanException(
                        String.format(Locale.ROOT, "is turned over in the unknown way %d; export it again", code));
            }
            return values()[code];
        }

        ScanChannel.Source undone(ScanChannel.Source samples, int columns) {
            return switch (this) {
                case NONE, HEIGHTS -> samples;
                case COLUMNS -> samples.mirrored(columns);
                case ROWS -> samples.upsideDown(columns);
            };
        }
    }

    /** Old files write the micro sign as DOS did. */
    private static String micro(String unit) {
        return unit.equals("\u00e6m") ? "um" : unit;
    }

    private static Extent extent(double pitchX, String unitX, double pitchY, String unitY, int columns, int rows) {
        Optional<Double> metresX = LengthUnit.metres(unitX);
        Optional<Double> metresY = LengthUnit.metres(unitY);
        boolean known = metresX.isPresent() && metresY.isPresent();
        return known
                ? Extent.ofPitches(pitchX * metresX.get(), pitchY * metresY.get(), "m", columns, rows)
                : Extent.ofPitches(pitchX, pitchY, "", columns, rows);
    }
}
