package sunbeam.app.cli.export;

import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.ErrorStatistics;

/** Writes a table in one format. Each writer serves one output. */
interface TableWriter {

    /** Refuses a wrong file name or an unwritable place, before anything is computed. */
    void check(Path output, Overwrite overwrite);

    /** Lower bound of the bytes of a table of this shape. */
    long leastBytes(GridShape shape);

    /** Size of a table in bytes. */
    default long bytes(ColorGrid grid) {
        return leastBytes(grid.shape());
    }

    /** Rounds a shape up to one that the format allows. */
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

    /** Returns the table as it is after writing and reading. */
    default ColorGrid asRead(ColorGrid grid) {
        return grid;
    }

    /** Errors of the written table. */
    default ErrorStatistics errors(TableText text) {
        return text.errors().sums();
    }

    /** Remarks on the written files, one line each. */
    default List<String> notes() {
        return List.of();
    }

    /**
     * Writes all files.
     *
     * @param baker source of coarser grids
     */
    List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableText text);
}
