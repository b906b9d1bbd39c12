package sunbeam.precompute.optics;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Heights in meters on a rectangular grid, seen from above: a scan, or one period of a surface. Column index grows with +x, row 0 is the
 * top (largest y). Missing samples are NaN or infinite until they are filled. Functions of the height need one value for each of the
 * distinct heights, the <em>levels</em>: 256 for a scan of 8 bits. Immutable, thread-safe; a class, since it finds range, digest and
 * levels on first use and keeps them: hashing or sorting 16 million samples takes seconds.
 */
public final class HeightMap {
    private static final int EXAMINED_SAMPLES = 8192;
    // With fewer, finding the levels costs more time than it saves.
    private static final double FEW_SAMPLES_PER_LEVEL = 4;

    private final int columns;
    private final int rows;
    private final double pitchX;
    private final double pitchY;
    private final double[] heights;

    // Concurrent threads may compute these two twice with the same result.
    private volatile DoubleSummaryStatistics range;
    private volatile String digest;
    private Distinct distinct;
    private int[] index;

    /**
     * @param pitchX distance of neighboring columns in meters, positive and finite
     * @param heights {@code rows * columns} heights in meters, row by row from the top; not copied, so that a large scan is not held
     *     twice: neither the caller nor readers may change them
     * @throws IllegalArgumentException if a size, pitch or the array's length does not fit
     */
    public HeightMap(int columns, int rows, double pitchX, double pitchY, double[] heights) {
        if (columns < 1 || rows < 1) {
            throw new IllegalArgumentException("a height map needs samples, got " + columns + " x " + rows);
        }
        if (!(pitchX > 0 && pitchY > 0 && Double.isFinite(pitchX) && Double.isFinite(pitchY))) {
            throw new IllegalArgumentException("pitch must be positive, got " + pitchX + " x " + pitchY + " m");
        }
        if (heights.length != (long) columns * rows) {
            throw new IllegalArgumentException("expected " + (long) columns * rows + " heights, got " + heights.length);
        }
        this.columns = columns;
        this.rows = rows;
        this.pitchX = pitchX;
        this.pitchY = pitchY;
        this.heights = heights;
    }

    public int columns() {
        return columns;
    }

    public int rows() {
        return rows;
    }

    public double pitchX() {
        return pitchX;
    }

    public double pitchY() {
        return pitchY;
    }

    public double[] heights() {
        return heights;
    }

    /** Returns this map with a known {@link #digest()}, since computing that of a large scan is slow. */
    public HeightMap withDigest(String known) {
        HeightMap same = with(heights);
        same.digest = known;
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
        return range().getCount() == 0 ? Double.NaN : range().getMin() + 0.0;
    }

    public double maximum() {
        return range().getCount() == 0 ? Double.NaN : range().getMax() + 0.0;
    }

    public double relief() {
        return maximum() - minimum();
    }

    public boolean isComplete() {
        return range().getCount() == heights.length;
    }

    private DoubleSummaryStatistics range() {
        if (range == null) {
            range = Arrays.stream(heights).filter(Double::isFinite).summaryStatistics();
        }
        return range;
    }

    /** Returns the SHA-256 of a tag, columns, rows (int), pitches and heights row by row (IEEE doubles), all big-endian, for cache keys. */
    public String digest() {
        if (digest == null) {
            digest = sha256();
        }
        return digest;
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

    private record Distinct(double[] levels, int[] counts) {
        static Distinct of(double[] sorted) {
            Arrays.parallelSort(sorted);
            int[] counts = new int[sorted.length];
            int count = 0;
            for (double height : sorted) {
                if (count == 0 || sorted[count - 1] != height) {
                    sorted[count++] = height;
                }
                counts[count - 1]++;
            }
            return count == sorted.length
                    ? new Distinct(sorted, counts)
                    : new Distinct(Arrays.copyOf(sorted, count), Arrays.copyOf(counts, count));
        }
    }

    private void requireComplete() {
        if (!isComplete()) {
            throw new IllegalStateException("missing samples must be filled first");
        }
    }

    private synchronized Distinct distinct() {
        if (distinct == null) {
            requireComplete();
            // Replaces -0 by 0; sorting and searching distinguish them.
            distinct = Distinct.of(map(height -> height + 0.0).heights());
        }
        return distinct;
    }

    /** Returns the distinct heights in meters, ascending; read-only. */
    public double[] levels() {
        return distinct().levels();
    }

    /** Returns the index of each sample's level, row by row; read-only. */
    public synchronized int[] index() {
        if (index == null) {
            index = indexed();
        }
        return index;
    }

    /** Searches in {@code count()} equal intervals; a search among all levels of 4096 x 4096 samples would take a minute. */
    private int[] indexed() {
        double[] levels = levels();
        double lowest = levels[0];
        double steps = levels.length / Math.max(levels[levels.length - 1] - lowest, Double.MIN_NORMAL);
        double perMeter = Double.isFinite(steps) ? steps : 0;
        int[] first = new int[levels.length + 2];
        int step = 0;
        for (int i = 0; i < levels.length; i++) {
            int reached = step(levels[i], lowest, perMeter, levels.length);
            while (step < reached) {
                first[++step] = i;
            }
        }
        Arrays.fill(first, step + 1, first.length, levels.length);
        int[] found = new int[heights.length];
        Arrays.parallelSetAll(found, i -> {
            double height = heights[i] + 0.0;
            int from = step(height, lowest, perMeter, levels.length);
            return Arrays.binarySearch(levels, first[from], first[from + 1], height);
        });
        return found;
    }

    /** Monotonic in spite of rounding; a height and its equal level get the same interval. */
    private static int step(double height, double lowest, double perMeter, int steps) {
        return (int) Math.min(steps, (height - lowest) * perMeter);
    }

    /** Estimates from some samples whether evaluating a function for all is faster than finding the levels, for complete heights. */
    public boolean hasTooManyLevels() {
        requireComplete();
        int samples = heights.length;
        int examined = Math.min(EXAMINED_SAMPLES, samples);
        double[] some = IntStream.range(0, examined)
                .mapToDouble(i -> heights[(int) ((long) i * samples / examined)] + 0.0)
                .toArray();
        double different = Arrays.stream(some).distinct().count();
        // With L levels, n samples have n^2 / (2 L) equal pairs if these are few (birthday problem).
        double levels = different < 0.5 * examined ? different : 0.5 * examined * examined / (examined - different);
        return levels > samples / FEW_SAMPLES_PER_LEVEL;
    }

    /** Returns the number of samples of each level. */
    public int[] histogram() {
        return distinct().counts();
    }

    /** Such as "512 x 256 samples, 20 um x 10 um". */
    public String describe() {
        return Text.format(
                "%d x %d samples, %s x %s", columns, rows, Lengths.format(width()), Lengths.format(height()));
    }
}
