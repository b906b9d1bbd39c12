package sunbeam.precompute.scan;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;

/**
 * One channel of a scan, known from the file's header; its samples are read when they are asked for.
 *
 * @param name as the file calls it; may be empty
 * @param columns samples along x, at least 1
 * @param rows samples along y, at least 1
 * @param unit of the samples as written; empty when the file does not say
 * @param source of the samples, in that unit
 */
public record ScanChannel(
        String name, Direction direction, int columns, int rows, Extent extent, String unit, Source source) {
    /** Unit of whole numbers of which the file only knows that full scale is 1: an image's. */
    public static final String FULL_SCALE = "full scale";

    /** Where samples come from; what instruments do to their order and scale is undone by what a source is put through. */
    @FunctionalInterface
    public interface Source {
        /** {@code rows * columns} samples row by row, row 0 the top of the scan, NaN where one is missing. */
        double[] read() throws IOException;

        /** {@code factor * sample + offset} of each. */
        default Source scaled(double factor, double offset) {
            return () -> Samples.scaled(read(), factor, offset);
        }

        /** The last row first: of files that begin at the bottom of the scan. */
        default Source upsideDown(int columns) {
            return () -> Samples.upsideDown(read(), columns);
        }

        /** The last column first: of files that begin at the right of the scan. */
        default Source mirrored(int columns) {
            return () -> Samples.mirrored(read(), columns);
        }

        /** NaN for a value that stands for a missing sample. */
        default Source withMissing(double mark) {
            return () -> Samples.withMissing(read(), mark);
        }
    }

    /** @throws ScanException when there are no samples */
    public ScanChannel {
        if (columns < 1 || rows < 1) {
            throw new ScanException(String.format(
                    Locale.ROOT, "claims %d x %d samples; the file is damaged, export it again", columns, rows));
        }
        name = name.strip();
        unit = unit.strip();
    }

    /** A channel of which the file does not say in which direction it was recorded. */
    public ScanChannel(String name, int columns, int rows, Extent extent, String unit, Source source) {
        this(name, Direction.UNKNOWN, columns, rows, extent, unit, source);
    }

    /** The same samples in rows of another length. */
    public ScanChannel inRows(int newColumns, int newRows) {
        return new ScanChannel(name, direction, newColumns, newRows, extent, unit, source);
    }

    /** Metres of one unit of the samples; nothing when the unit is none of length, or not known. */
    public Optional<Double> metresPerUnit() {
        return LengthUnit.metres(unit);
    }

    /** Whether the samples may be heights: in a unit of length, of full scale, or without any unit. */
    public boolean maybeHeights() {
        return unit.isEmpty() || unit.equals(FULL_SCALE) || metresPerUnit().isPresent();
    }

    /**
     * The samples, in the channel's unit.
     *
     * @throws ScanException when they are too many, or not there
     */
    public double[] samples() throws IOException {
        ScanLimits.requireSize(columns, rows);
        ScanLimits.requireMemory((long) columns * rows, 0, Runtime.getRuntime().maxMemory());
        double[] samples = source.read();
        if (samples.length != columns * rows) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %d samples where %d x %d are announced; export it again",
                    samples.length,
                    columns,
                    rows));
        }
        return samples;
    }
}
