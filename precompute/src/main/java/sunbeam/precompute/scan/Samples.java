package sunbeam.precompute.scan;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntUnaryOperator;
import java.util.function.UnaryOperator;
import sunbeam.precompute.text.Text;

/**
 * Grid of samples, read when {@link #read} is called, row by row from the top of the scan, NaN for missing ones. Limits are checked from a
 * file's header before memory is taken.
 */
public record Samples(int columns, int rows, Source source) {
    /** Samples: three times the longest side that the software of force microscopes writes. */
    public static final int LONGEST_SIDE = 16_384;
    /** 8192 x 8192, whose heights take half a gigabyte. */
    public static final long MOST_SAMPLES = 1L << 26;

    // Leveling holds two arrays of heights; gaps in the heap take up to a third more.
    private static final int BYTES_PER_HEIGHT = 3 * Double.BYTES;

    @FunctionalInterface
    public interface Source {
        double[] read() throws IOException;
    }

    /** Refuses an empty grid, or one with more samples than an array holds. */
    public Samples {
        if (columns < 1 || rows < 1 || (long) columns * rows > Integer.MAX_VALUE) {
            requireSize(columns, rows);
        }
    }

    public static void requireSize(long columns, long rows) {
        ScanException.refuseIf(
                columns < 1 || rows < 1,
                "claims " + columns + " x " + rows + " samples; the file is damaged, export it again");
        ScanException.refuseIf(
                columns > LONGEST_SIDE || rows > LONGEST_SIDE || columns * rows > MOST_SAMPLES,
                "has " + columns + " x " + rows + " samples; at most " + LONGEST_SIDE + " per side and " + MOST_SAMPLES
                        + " (8192 x 8192) in all can be used, so crop the scan");
        ScanException.refuseIf(
                columns == 1 && rows == 1, "has 1 x 1 samples, which is no surface; give at least 2 x 1 samples");
    }

    /** Refuses scans that the heap cannot hold with {@code otherBytes} while they are read and leveled. */
    public static void requireMemory(long samples, long otherBytes) {
        long needed = samples * BYTES_PER_HEIGHT + otherBytes;
        long heap = Runtime.getRuntime().maxMemory();
        if (needed > heap) {
            throw new ScanException(Text.format(
                    "needs %.1f GB of memory, but Java may take %.1f GB; crop the scan or start Java with a larger -Xmx",
                    needed / 1e9, heap / 1e9));
        }
    }

    /** Returns consecutive samples; refuses a file that ends before the last one. */
    public static Samples of(ScanBytes file, long offset, int columns, int rows, SampleType type, ByteOrder order) {
        Samples samples = new Samples(
                columns, rows, () -> type.read(file.stream(offset), Math.multiplyExact(columns, rows), order));
        file.requireInside(offset, samples.count() * type.size());
        return samples;
    }

    public static Samples of(ScanBytes file, long offset, int columns, int rows, SampleType type) {
        return of(file, offset, columns, rows, type, ByteOrder.LITTLE_ENDIAN);
    }

    public long count() {
        return (long) columns * rows;
    }

    /** The change may overwrite the array. */
    public Samples mapAll(UnaryOperator<double[]> change) {
        return new Samples(columns, rows, () -> change.apply(source.read()));
    }

    public Samples map(DoubleUnaryOperator change) {
        return mapAll(samples -> {
            Arrays.setAll(samples, i -> change.applyAsDouble(samples[i]));
            return samples;
        });
    }

    public Samples scale(double factor, double offset) {
        return map(sample -> factor * sample + offset);
    }

    public Samples withMissing(double mark) {
        return map(sample -> sample == mark ? Double.NaN : sample);
    }

    public Samples flipRows() {
        return reorder(i -> (rows - 1 - i / columns) * columns + i % columns);
    }

    public Samples flipColumns() {
        return reorder(i -> i - 2 * (i % columns) + columns - 1);
    }

    /** Sample i of the result is the present sample {@code origin(i)}. */
    public Samples reorder(IntUnaryOperator origin) {
        return mapAll(samples -> {
            double[] moved = new double[samples.length];
            Arrays.parallelSetAll(moved, i -> samples[origin.applyAsInt(i)]);
            return moved;
        });
    }

    /** Throws ScanException if there are too many, or fewer than announced. */
    public double[] read() throws IOException {
        requireSize(columns, rows);
        requireMemory(count(), 0);
        double[] samples = source.read();
        if (samples.length != count()) {
            throw new ScanException("has " + samples.length + " samples where " + columns + " x " + rows
                    + " are announced; export it again");
        }
        return samples;
    }
}
