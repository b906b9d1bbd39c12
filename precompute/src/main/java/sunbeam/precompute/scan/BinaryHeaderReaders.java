package sunbeam.precompute.scan;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Text;

/** Readers of files with binary fields at fixed positions, and samples after them. */
final class BinaryHeaderReaders {
    private static final int SURF_HEADER = 512;
    // Others are profiles, binary images and series.
    private static final int SURFACE = 2;
    // Distance of the value of missing samples below the header's minimum.
    private static final int BELOW_LOWEST = 2;
    private static final int SURF_TEXT = 16;
    private static final Pattern NUMPY_TYPE = Pattern.compile("'descr'\\s*:\\s*'([<>=|]?)([a-zA-Z])(\\d+)'");
    private static final Pattern NUMPY_ORDER = Pattern.compile("'fortran_order'\\s*:\\s*(True|False)");
    private static final Pattern NUMPY_SHAPE =
            Pattern.compile("'shape'\\s*:\\s*\\(\\s*(\\d{1,18})\\s*,\\s*(?:(\\d{1,18})\\s*,?\\s*)?\\)");

    private static final Map<String, String> NUMPY_KINDS = Map.of("f", "FLOAT", "i", "SIGNED", "u", "UNSIGNED");
    // Lengths of the headers and positions of fields, bytes.
    private static final int WAVE_FIRST_HEADER = 64;
    private static final int WAVE_HEADERS = WAVE_FIRST_HEADER + 320;
    private static final int WAVE_TYPE = WAVE_FIRST_HEADER + 16;
    private static final int WAVE_DIMENSIONS = WAVE_FIRST_HEADER + 68;
    private static final int WAVE_DATA_UNIT = WAVE_FIRST_HEADER + 148;
    private static final int LABEL_LENGTH = 32;
    private static final int LARGEST_TEXT = 1 << 20;

    private static final Map<Integer, SampleType> WAVE_TYPES = Map.of(
            0x02, SampleType.FLOAT_32,
            0x04, SampleType.FLOAT_64,
            0x08, SampleType.SIGNED_8,
            0x10, SampleType.SIGNED_16,
            0x20, SampleType.SIGNED_32,
            0x48, SampleType.UNSIGNED_8,
            0x50, SampleType.UNSIGNED_16,
            0x60, SampleType.UNSIGNED_32);

    private BinaryHeaderReaders() {}

    /**
     * Reads .sur files by Digital Surf (MountainsMap): a header of 512 bytes, a comment, integers from the top row. Source of all offsets:
     * Digital Surf, "SURF file format".
     */
    static List<ScanChannel> digitalSurf(ScanBytes file) throws IOException {
        ScanException.refuseIf(
                file.startsWith("DSCOMPRESSED"), "is compressed in a way of its own; save it without compression");
        ScanBytes.Cursor header = file.cursor(0, ByteOrder.LITTLE_ENDIAN);
        int objects = header.at(14).unsigned16();
        int kind = header.at(18).unsigned16();
        ScanException.refuseIf(
                objects != 1 || kind != SURFACE,
                "holds " + objects + " objects of type " + kind + " and no single surface; export the surface alone");
        boolean hasMissing = header.at(86).unsigned16() == 1;
        SampleType type = SampleType.signed(header.at(98).unsigned16());
        double missing = hasMissing ? (double) header.int32() - BELOW_LOWEST : Double.NaN;
        int columns = header.at(108).int32();
        int rows = header.int32();
        double pitchX = header.at(120).float32();
        double pitchY = header.float32();
        double step = header.float32();
        String name = header.at(164).text(SURF_TEXT);
        String unitX = header.text(SURF_TEXT);
        String unitY = header.text(SURF_TEXT);
        String unitZ = header.text(SURF_TEXT);
        int inversion = header.at(290).unsigned16();
        long start = SURF_HEADER + header.at(334).unsigned16() + (long) header.unsigned16();
        Samples stored = Samples.of(file, start, columns, rows, type).withMissing(missing);
        // Heights are inverted too for codes 1 to 3.
        Samples heights = (switch (inversion) {
                    case 0, 1 -> stored;
                    case 2 -> stored.flipColumns();
                    case 3 -> stored.flipRows();
                    default ->
                        throw new ScanException("is turned over in the unknown way " + inversion + "; export it again");
                })
                .scale(inversion == 0 ? step : -step, 0);
        double metersY =
                Extent.metersPer(unitY).orElse(1.0) / Extent.metersPer(unitX).orElse(1.0);
        Extent extent = Extent.ofPitches(pitchX, pitchY * metersY, unitX, stored);
        return List.of(new ScanChannel(name, heights, extent, unitZ));
    }

    /** Reads .npy files: one array, rows by columns, row 0 at the top, without size and unit. Source: NumPy manual, "numpy.lib.format". */
    static List<ScanChannel> numpy(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(6, ByteOrder.LITTLE_ENDIAN);
        int version = cursor.unsignedByte();
        cursor.skip(1);
        long length = version == 1 ? cursor.unsigned16() : cursor.unsigned32();
        long start = cursor.position() + length;
        String header = cursor.text((int) Math.min(length, Integer.MAX_VALUE));
        Matcher type = find(NUMPY_TYPE, header, "holds no plain numbers");
        Matcher fortran = find(NUMPY_ORDER, header, "does not say its order");
        Matcher shape = find(NUMPY_SHAPE, header, "holds no array of rows and columns");
        boolean oneDimensional = shape.group(2) == null;
        long rowCount = oneDimensional ? 1 : Long.parseLong(shape.group(1));
        long columnCount = Long.parseLong(shape.group(oneDimensional ? 1 : 2));
        Samples.requireSize(columnCount, rowCount);
        int rows = (int) rowCount;
        int columns = (int) columnCount;
        ByteOrder order = type.group(1).equals(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
        SampleType sampleType = SampleType.find(NUMPY_KINDS.get(type.group(2)), type.group(3))
                .orElseThrow(() -> new ScanException("holds numbers of type " + type.group(2) + type.group(3)
                        + ", which is not read; save a.astype('float64')"));
        Samples stored = Samples.of(file, start, columns, rows, sampleType, order);
        boolean byColumns = fortran.group(1).equals("True");
        Samples byRows = byColumns ? stored.reorder(i -> i % columns * rows + i / columns) : stored;
        return List.of(new ScanChannel("", byRows, Extent.UNKNOWN, ""));
    }

    private static Matcher find(Pattern pattern, String header, String otherwise) {
        Matcher matcher = pattern.matcher(header);
        ScanException.refuseIf(
                !matcher.find(),
                otherwise + " (" + Text.quoted(header.strip()) + "); save a two-dimensional array of heights");
        return matcher;
    }

    static boolean isIgorWave(ScanBytes file) throws IOException {
        if (!file.startsWith("\5\0", "\0\5") || file.size() < WAVE_HEADERS) {
            return false;
        }
        // The 16-bit words of both headers, which include a checksum, add up to zero.
        ScanBytes.Cursor words = file.cursor(0, order(file));
        int sum = 0;
        while (words.position() < WAVE_HEADERS) {
            sum += words.int16();
        }
        return (sum & 0xffff) == 0;
    }

    private static ByteOrder order(ScanBytes file) throws IOException {
        return file.head(1)[0] == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    }

    /**
     * Reads Igor binary waves of version 5 (Asylum Research): layers are channels named by their labels, rows from the bottom. Source:
     * WaveMetrics, "Igor Technical Note 003".
     */
    static List<ScanChannel> igorWave(ScanBytes file) throws IOException {
        ByteOrder order = order(file);
        ScanBytes.Cursor cursor = file.cursor(8, order);
        // Nine parts lie between samples and layers' labels: formula, note, five units, labels of two dimensions.
        long beforeLabels = 0;
        for (int i = 0; i < 9; i++) {
            beforeLabels += cursor.unsigned32();
        }
        long labels = cursor.unsigned32();
        SampleType type = SampleType.of(WAVE_TYPES, cursor.at(WAVE_TYPE).int16());
        int columns = cursor.at(WAVE_DIMENSIONS).int32();
        int rows = cursor.int32();
        int layers = Math.max(1, cursor.int32());
        ScanException.refuseIf(rows < 1, "holds a curve and no scan; choose the file of the image");
        ChannelList.requireCount(layers);
        Samples.requireSize(columns, rows);
        cursor.skip(Integer.BYTES);
        double pitchX = Math.abs(cursor.float64());
        double pitchY = Math.abs(cursor.float64());
        String unit = cursor.at(WAVE_DATA_UNIT).text(4);
        String unitXy = cursor.text(4);
        long bytes = (long) columns * rows * type.size();
        file.requireInside(WAVE_HEADERS, bytes * layers);
        boolean hasLabels = labels >= (long) LABEL_LENGTH * (layers + 1) && labels <= LARGEST_TEXT;
        // The label of the dimension precedes those of the layers.
        ScanBytes.Cursor label = file.cursor(WAVE_HEADERS + bytes * layers + beforeLabels + LABEL_LENGTH, order);
        List<ScanChannel> channels = new ArrayList<>();
        for (int layer = 0; layer < layers; layer++) {
            String name = hasLabels ? label.text(LABEL_LENGTH) : "";
            Samples samples = Samples.of(file, WAVE_HEADERS + bytes * layer, columns, rows, type, order);
            Extent extent = Extent.ofPitches(pitchX, pitchY, unitXy, samples);
            channels.add(new ScanChannel(name, name.endsWith("Retrace"), samples.flipRows(), extent, unit(name, unit)));
        }
        return channels;
    }

    /** A wave has one unit, meters, even for layers of phases and potentials. */
    private static String unit(String name, String unit) {
        boolean volts = name.contains("Potential") || name.startsWith("UserIn") || name.startsWith("Current");
        return name.startsWith("Phase") ? "deg" : volts ? "V" : unit;
    }
}
