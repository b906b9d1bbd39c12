package sunbeam.precompute.patch;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.prepare.HeightField;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.prepare.Preparation;
import sunbeam.precompute.units.Lengths;

/**
 * One period of a surface: heights in metres on a rectangular grid, seen from above. Column index grows with +x, row 0
 * is the top (largest y); the surface repeats this patch periodically in both directions.
 *
 * <p>Immutable. Missing samples are NaN until they are filled ({@link HeightField}).
 */
public final class HeightMap {
    private final int columns;
    private final int rows;
    private final double pitchX;
    private final double pitchY;
    private final double[] heights;
    private Range range;
    private String digest;

    /**
     * @param columns number of samples along x, at least 1
     * @param rows number of samples along y, at least 1
     * @param pitchX distance of neighboring columns in metres, positive and finite
     * @param pitchY distance of neighboring rows in metres, positive and finite
     * @param heights {@code rows * columns} heights in metres, row by row from the top; copied
     * @throws IllegalArgumentException when a size, pitch or the array's length does not fit
     */
    public HeightMap(int columns, int rows, double pitchX, double pitchY, double[] heights) {
        this(heights.clone(), columns, rows, pitchX, pitchY);
    }

    /** As the public constructor, but keeps the array itself: a large scan is not held twice. */
    private HeightMap(double[] heights, int columns, int rows, double pitchX, double pitchY) {
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

    /** A height map that takes over the array: the caller must not touch it again. */
    static HeightMap owning(int columns, int rows, double pitchX, double pitchY, double[] heights) {
        return new HeightMap(heights, columns, rows, pitchX, pitchY);
    }

    /** The map of a field, whose array it takes over. */
    static HeightMap of(HeightField field) {
        return new HeightMap(field.heights(), field.columns(), field.rows(), field.pitchX(), field.pitchY());
    }

    /** The heights as preparing takes them; not to be written to. */
    HeightField field() {
        return new HeightField(columns, rows, pitchX, pitchY, heights);
    }

    /** The same grid with something subtracted. */
    public HeightMap levelled(Levelling levelling) {
        return of(levelling.apply(field()));
    }

    /**
     * A part of it, as it is.
     *
     * @throws IllegalArgumentException when that leaves the map or holds fewer than two samples
     */
    public HeightMap part(Crop crop) {
        Preparation cropping = new Preparation(Optional.of(crop), Levelling.NONE, false, Edges.REPEAT);
        return of(cropping.cropped(field()));
    }

    public int columns() {
        return columns;
    }

    public int rows() {
        return rows;
    }

    /** Distance of neighboring columns, metres. */
    public double pitchX() {
        return pitchX;
    }

    /** Distance of neighboring rows, metres. */
    public double pitchY() {
        return pitchY;
    }

    /** Period along x, metres. */
    public double width() {
        return columns * pitchX;
    }

    /** Period along y, metres. */
    public double height() {
        return rows * pitchY;
    }

    /** Height in metres at a column (0 = left) and row (0 = top). */
    public double at(int column, int row) {
        return heights[row * columns + column];
    }

    /** A copy of all heights in metres, row by row from the top. */
    public double[] toArray() {
        return heights.clone();
    }

    /** Lowest height in metres, ignoring missing samples; NaN when all are missing. */
    public double minimum() {
        return range().low();
    }

    /** Highest height in metres, ignoring missing samples; NaN when all are missing. */
    public double maximum() {
        return range().high();
    }

    /** Lowest and highest height; NaN when all are missing. */
    private record Range(double low, double high) {
        static Range of(double[] heights) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (double height : heights) {
                // False for NaN.
                if (height < low && height > Double.NEGATIVE_INFINITY) {
                    low = height;
                }
                if (height > high && height < Double.POSITIVE_INFINITY) {
                    high = height;
                }
            }
            return low <= high ? new Range(low, high) : new Range(Double.NaN, Double.NaN);
        }
    }

    /** {@link HeightDigest#sha256}, found once; threads that look at the same time find the same. */
    String digest() {
        String known = digest;
        if (known == null) {
            known = HeightDigest.sha256(this);
            digest = known;
        }
        return known;
    }

    /** Found once; threads that look at the same time find the same. */
    private Range range() {
        Range known = range;
        if (known == null) {
            known = Range.of(heights);
            range = known;
        }
        return known;
    }

    /** Peak to valley, metres. */
    public double relief() {
        return range().high() - range().low();
    }

    /** For people: "512 x 256 samples, 20 um x 10 um". */
    public String describe() {
        return String.format(
                Locale.ROOT,
                "%d x %d samples, %s x %s",
                columns,
                rows,
                Lengths.format(width()),
                Lengths.format(height()));
    }

    /** The same grid with every height replaced by a function of it. */
    public HeightMap map(DoubleUnaryOperator function) {
        return owning(
                columns,
                rows,
                pitchX,
                pitchY,
                Arrays.stream(heights).map(function).toArray());
    }
}
