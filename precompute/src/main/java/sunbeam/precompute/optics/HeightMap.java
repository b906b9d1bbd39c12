package sunbeam.precompute.optics;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.function.DoubleUnaryOperator;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Heights in meters on a rectangular grid, seen from above: a scan, or one period of a surface. Column index grows with +x, row 0 is the
 * top (largest y). Immutable. Missing samples are NaN or infinite until they are filled.
 *
 * @param pitchX distance of neighboring columns in meters, positive and finite
 * @param heights {@code rows * columns} heights in meters, row by row from the top; not copied, so that a large scan is not held twice:
 *     neither the caller nor readers may change them
 * @param derived values that are computed on first use
 */
public record HeightMap(
        int columns, int rows, double pitchX, double pitchY, double[] heights, HeightMap.Derived derived) {
    /** Statistics of the samples that are not missing, and the digest. Concurrent threads may compute them twice with the same result. */
    static final class Derived {
        private volatile DoubleSummaryStatistics range;
        private volatile String digest;
    }

    /** Throws IllegalArgumentException if a size, pitch or the array's length does not fit. */
    public HeightMap {
        if (columns < 1 || rows < 1) {
            throw new IllegalArgumentException("a height map needs samples, got " + columns + " x " + rows);
        }
        if (!(pitchX > 0 && pitchY > 0 && Double.isFinite(pitchX) && Double.isFinite(pitchY))) {
            throw new IllegalArgumentException("pitch must be positive, got " + pitchX + " x " + pitchY + " m");
        }
        if (heights.length != (long) columns * rows) {
            throw new IllegalArgumentException("expected " + (long) columns * rows + " heights, got " + heights.length);
        }
    }

    public HeightMap(int columns, int rows, double pitchX, double pitchY, double[] heights) {
        this(columns, rows, pitchX, pitchY, heights, new Derived());
    }

    /** Returns this map with a known {@link #digest()}, since computing that of a large scan is slow. */
    public HeightMap withDigest(String known) {
        HeightMap same = with(heights);
        same.derived.digest = known;
        return same;
    }

    public HeightMap with(double[] others) {
        return new HeightMap(columns, rows, pitchX, pitchY, others);
    }

    public HeightMap part(int firstColumn, int firstRow, int partColumns, int partRows) {
        double[] part = new double[partColumns * partRows];
        for (int row = 0; row < partRows; row++) {
            System.arraycopy(heights, (firstRow + row) * columns + firstColumn, part, row * partColumns, partColumns);
        }
        return new HeightMap(partColumns, partRows, pitchX, pitchY, part);
    }

    public HeightMap map(DoubleUnaryOperator function) {
        return with(Arrays.stream(heights).map(function).toArray());
    }

    /** Returns the extent along x, meters: the period of a surface that repeats. */
    public double width() {
        return columns * pitchX;
    }

    public double height() {
        return rows * pitchY;
    }

    /** Returns the height in meters at a column (0 = left) and row (0 = top). */
    public double at(int column, int row) {
        return heights[row * columns + column];
    }

    /** Returns the lowest height in meters, ignoring missing samples; NaN when all are missing. */
    public double minimum() {
        return range().getCount() == 0 ? Double.NaN : range().getMin();
    }

    public double maximum() {
        return range().getCount() == 0 ? Double.NaN : range().getMax();
    }

    public double relief() {
        return maximum() - minimum();
    }

    public boolean isComplete() {
        return range().getCount() == heights.length;
    }

    private DoubleSummaryStatistics range() {
        if (derived.range == null) {
            derived.range = Arrays.stream(heights).filter(Double::isFinite).summaryStatistics();
        }
        return derived.range;
    }

    /** Returns the SHA-256 of a tag, columns, rows (int), pitches and heights row by row (IEEE doubles), all big-endian, for cache keys. */
    public String digest() {
        if (derived.digest == null) {
            derived.digest = sha256();
        }
        return derived.digest;
    }

    private String sha256() {
        Sha256 sha = new Sha256();
        sha.add("sunbeam height map 1\n");
        sha.add(ByteBuffer.allocate(2 * Integer.BYTES + 2 * Double.BYTES)
                .putInt(columns)
                .putInt(rows)
                .putDouble(pitchX)
                .putDouble(pitchY)
                .flip());
        ByteBuffer line = ByteBuffer.allocate(Double.BYTES * columns);
        for (int row = 0; row < rows; row++) {
            line.clear().asDoubleBuffer().put(heights, row * columns, columns);
            sha.add(line);
        }
        return sha.hex();
    }

    /** Such as "512 x 256 samples, 20 um x 10 um". */
    public String describe() {
        return Text.format(
                "%d x %d samples, %s x %s", columns, rows, Lengths.format(width()), Lengths.format(height()));
    }
}
