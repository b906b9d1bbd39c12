package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.text.Quoted;

/** Reader of .npy files: one array, rows by columns, row 0 at the top, without size and unit. Source: NumPy manual, "numpy.lib.format". */
final class NumpyReader {
    private static final Pattern TYPE = Pattern.compile("'descr'\\s*:\\s*'([<>=|]?)([a-zA-Z])(\\d+)'");
    private static final Pattern FORTRAN = Pattern.compile("'fortran_order'\\s*:\\s*(True|False)");
    private static final Pattern SHAPE =
            Pattern.compile("'shape'\\s*:\\s*\\(\\s*(\\d{1,18})\\s*,\\s*(?:(\\d{1,18})\\s*,?\\s*)?\\)");

    private static final Map<String, SampleType> TYPES = Map.of(
            "f2", SampleType.FLOAT_16,
            "f4", SampleType.FLOAT_32,
            "f8", SampleType.FLOAT_64,
            "i1", SampleType.SIGNED_8,
            "i2", SampleType.SIGNED_16,
            "i4", SampleType.SIGNED_32,
            "i8", SampleType.SIGNED_64,
            "u1", SampleType.UNSIGNED_8,
            "u2", SampleType.UNSIGNED_16,
            "u4", SampleType.UNSIGNED_32);

    private NumpyReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        ScanBytes.Cursor cursor = file.cursor(6, ByteOrder.LITTLE_ENDIAN);
        int version = cursor.unsignedByte();
        cursor.skip(1);
        long length = version == 1 ? cursor.unsigned16() : cursor.unsigned32();
        long start = cursor.position() + length;
        String header = new String(
                file.read(cursor.position(), (int) Math.min(length, Integer.MAX_VALUE))
                        .array(),
                StandardCharsets.ISO_8859_1);
        Matcher type = find(TYPE, header, "holds no plain numbers");
        Matcher fortran = find(FORTRAN, header, "does not say its order");
        Matcher shape = find(SHAPE, header, "holds no array of rows and columns");
        boolean oneDimensional = shape.group(2) == null;
        long rowCount = oneDimensional ? 1 : Long.parseLong(shape.group(1));
        long columnCount = Long.parseLong(shape.group(oneDimensional ? 1 : 2));
        ScanLimits.requireSize(columnCount, rowCount);
        int rows = (int) rowCount;
        int columns = (int) columnCount;
        ByteOrder order = type.group(1).equals(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
        String code = type.group(2) + type.group(3);
        if (!TYPES.containsKey(code)) {
            throw new ScanException("holds numbers of type " + code + ", which is not read; save a.astype('float64')");
        }
        Samples stored = Samples.of(file, start, columns, rows, TYPES.get(code), order);
        boolean byColumns = fortran.group(1).equals("True");
        Samples byRows = byColumns ? stored.reorder(i -> i % columns * rows + i / columns) : stored;
        return List.of(new ScanChannel("", byRows, Extent.UNKNOWN, ""));
    }

    private static Matcher find(Pattern pattern, String header, String otherwise) {
        Matcher matcher = pattern.matcher(header);
        if (!matcher.find()) {
            throw new ScanException(
                    otherwise + " (" + Quoted.of(header.strip()) + "); save a two-dimensional array of heights");
        }
        return matcher;
    }
}
