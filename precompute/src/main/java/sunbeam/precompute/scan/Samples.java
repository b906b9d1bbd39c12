package sunbeam.precompute.scan;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntUnaryOperator;
import java.util.function.UnaryOperator;

/** Grid of samples, read when {@link #read} is called, row by row from the top of the scan, NaN for missing ones. */
public record Samples(int columns, int rows, Source source) {
    @FunctionalInterface
    public interface Source {
        double[] read() throws IOException;
    }

    /** Refuses an empty grid, or one with more samples than an array holds. */
    public Samples {
        if (columns < 1 || rows < 1 || (long) columns * rows > Integer.MAX_VALUE) {
            ScanLimits.requireSize(columns, rows);
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
        ScanLimits.requireSize(columns, rows);
        ScanLimits.requireMemory(count(), 0);
        double[] samples = source.read();
        if (samples.length != count()) {
            throw new ScanException("has " + samples.length + " samples where " + columns + " x " + rows
                    + " are announced; export it again");
        }
        return samples;
    }
}
