package sunbeam.precompute.scan;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;

/**
 * A grid of samples in a file, read when they are asked for; what instruments do to their order and scale is undone by what
 * they are put through.
 *
 * @param columns samples along x, at least 1
 * @param rows samples along y, at least 1
 * @param source of {@code rows * columns} samples row by row, row 0 the top of the scan, NaN where one is missing
 */
public record Samples(int columns, int rows, Source source) {
    /** Where samples come from. */
    @FunctionalInterface
    public interface Source {
        double[] read() throws IOException;
    }

    /** @throws ScanException when there are none, or more than any array holds */
    public Samples {
        if (columns < 1 || rows < 1 || (long) columns * rows > Integer.MAX_VALUE) {
            ScanLimits.requireSize(columns, rows);
        }
    }

    /**
     * Samples that lie in a file one after the other.
     *
     * @param offset of the first, bytes
     * @throws ScanException when the file ends before the last, so that a header cannot ask for more than is there
     */
    public static Samples of(ScanBytes file, long offset, int columns, int rows, SampleType type, ByteOrder order) {
        Samples samples = new Samples(
                columns, rows, () -> type.read(file.stream(offset), Math.multiplyExact(columns, rows), order));
        file.requireInside(offset, samples.count() * type.size());
        return samples;
    }

    /** As above, little-endian. */
    public static Samples of(ScanBytes file, long offset, int columns, int rows, SampleType type) {
        return of(file, offset, columns, rows, type, ByteOrder.LITTLE_ENDIAN);
    }

    /** How many. */
    public long count() {
        return (long) columns * rows;
    }

    /** All of them changed together, an array that may be written to. */
    public Samples changed(UnaryOperator<double[]> change) {
        return new Samples(columns, rows, () -> change.apply(source.read()));
    }

    /** Each of them changed alone. */
    public Samples each(DoubleUnaryOperator change) {
        return changed(samples -> {
            Arrays.setAll(samples, i -> change.applyAsDouble(samples[i]));
            return samples;
        });
    }

    /** {@code factor * sample + offset} of each. */
    public Samples scaled(double factor, double offset) {
        return each(sample -> factor * sample + offset);
    }

    /** NaN for a value that stands for a missing sample. */
    public Samples withMissing(double mark) {
        return each(sample -> sample == mark ? Double.NaN : sample);
    }

    /** The last row first: of files that begin at the bottom of the scan. */
    public Samples upsideDown() {
        return changed(samples -> {
            double[] row = new double[columns];
            for (int top = 0, bottom = rows - 1; top < bottom; top++, bottom--) {
                System.arraycopy(samples, top * columns, row, 0, columns);
                System.arraycopy(samples, bottom * columns, samples, top * columns, columns);
                System.arraycopy(row, 0, samples, bottom * columns, columns);
            }
            return samples;
        });
    }

    /** The last column first: of files that begin at the right of the scan. */
    public Samples mirrored() {
        return changed(samples -> {
            for (int start = 0; start < samples.length; start += columns) {
                for (int left = start, right = start + columns - 1; left < right; left++, right--) {
                    double sample = samples[left];
                    samples[left] = samples[right];
                    samples[right] = sample;
                }
            }
            return samples;
        });
    }

    /** The same samples in rows of another length. */
    public Samples inRows(int newColumns, int newRows) {
        return new Samples(newColumns, newRows, source);
    }

    /**
     * Reads all.
     *
     * @throws ScanException when they are too many, or not there
     */
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
