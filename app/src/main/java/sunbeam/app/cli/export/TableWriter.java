package sunbeam.app.cli.export;

import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.ErrorStatistics;

/** Writes a table as a format has it. Made for one output. */
interface TableWriter {

    /** Refuses early a name that does not fit, or a place that takes nothing. */
    void check(Path output, Overwrite overwrite);

    /** Bytes that tables of a shape take at least. */
    long leastBytes(GridShape shape);

    /** Bytes that a table takes. */
    default long bytes(ColorGrid grid) {
        return leastBytes(grid.shape());
    }

    /** A shape that the format has, no smaller. */
    default GridShape fitted(GridShape shape) {
        return shape;
    }

    /** Numbers that are in memory at once. */
    default long numbers(GridShape shape) {
        return ColorGrid.CHANNELS * shape.allTexels();
    }

    /** The functions of the wavelength, light times observer for example, in which errors are measured. */
    default CieTable measured(CieTable light) {
        return light;
    }

    /** What a table is once it has been written and read. */
    default ColorGrid asRead(ColorGrid grid) {
        return grid;
    }

    /** Returns the errors of what was written, as it is read. */
    default ErrorStatistics errors(TableText text) {
        return text.errors().sums();
    }

    /** What there is to say of what was written, a line each. */
    default List<String> notes() {
        return List.of();
    }

    /**
     * All files, of the grid that the command has made.
     *
     * @param baker of coarser grids
     */
    List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableText text);
}
