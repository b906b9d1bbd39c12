package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.text.Quoted;

/**
 * NumPy .npy: one array of numbers, rows by columns, row 0 the top; size and unit must be said. Source: NumPy manual,
 * "numpy.lib.format".
 */
final class NumpyReader implements ScanReader {
    private static final String MAGIC = "\u0093NUMPY";
    private static final Pattern TYPE = Pattern.compile("'descr'\\s*:\\s*'([<>=|]?)([a-zA-Z])(\\d+)'");
    private static final Pattern FORTRAN = Pattern.compile("'fortran_order'\\s*:\\s*(True|False)");
    private static final Pattern SHAPE =
            Pattern.compile("'shape'\\s*:\\s*\\(\\s*(\\d{1,9})\\s*,\\s*(?:(\\d{1,9})\\s*,?\\s*)?\\)");

    @Override
    public String format() {
        return "NumPy (.npy)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith(MAGIC);
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        ByteCursor cursor = file.cursor(6, ByteOrder.LITTLE_ENDIAN);
        int version = cursor.unsignedByte();
        cursor.skip(1);
        long length = version == 1 ? cursor.unsigned16() : cursor.unsigned32();
        long start = cursor.position() + length;
        if (length > ScanBytes.LARGEST_HEADER) {
            throw new ScanException(String.format(
                    Locale.ROOT, "claims a header of %d bytes; the file is damaged, save it again", length));
        }
        String header = new String(file.read(cursor.position(), (int) length).array(), StandardCharsets.ISO_8859_1);
        Matcher type = find(TYPE, header, "holds no plain numbers");
        Matcher fortran = find(FORTRAN, header, "does not say its order");
        Matcher shape = find(SHAPE, header, "holds no array of rows and columns");
        boolean row = shape.group(2) == null;
        int rows = row ? 1 : Integer.parseInt(shape.group(1));
        int columns = Integer.parseInt(shape.group(row ? 1 : 2));
        ByteOrder order = type.group(1).equals(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
        SampleType samples = type(type.group(2) + type.group(3));
        ScanChannel.Source stored = SampleBlock.of(file, start, (long) columns * rows, samples, order);
        boolean byColumns = fortran.group(1).equals("True");
        return List.of(new ScanChannel(
                "",
                columns,
                rows,
                Extent.UNKNOWN,
                "",
                byColumns ? () -> transposed(stored.read(), columns, rows) : stored));
    }

    private static Matcher find(Pattern pattern, String header, String otherwise) {
        Matcher matcher = pattern.matcher(header);
        if (!matcher.find()) {
            throw new ScanException(
                    otherwise + " (" + Quoted.of(header.strip()) + "); save a two-dimensional array of heights");
        }
        return matcher;
    }

    private static SampleType type(String code) {
        return switch (code) {
            case "f4" -> SampleType.FLOAT_32;
            case "f8" -> SampleType.FLOAT_64;
            case "i1" -> SampleType.SIGNED_8;
            case "i2" -> SampleType.SIGNED_16;
            case "i4" -> SampleType.SIGNED_32;
            case "i8" -> SampleType.SIGNED_64;
            case "u1" -> SampleType.UNSIGNED_8;
            case "u2" -> SampleType.UNSIGNED_16;
            case "u4" -> SampleType.UNSIGNED_32;
            default -> throw new ScanException("holds numbers of the type " + code + "; save it as float64");
        };
    }

    /** Rows of what was stored column by column. */
    private static double[] transposed(double[] samples, int columns, int rows) {
        double[] turned = new double[samples.length];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                turned[row * columns + column] = samples[column * rows + row];
            }
        }
        return turned;
    }
}
