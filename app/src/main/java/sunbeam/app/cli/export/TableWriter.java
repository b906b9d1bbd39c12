package sunbeam.app.cli.export;

import java.util.List;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.ErrorStatistics;

/** Converts a color grid to the files of one format. A writer is used for one output only. */
interface TableWriter {
    /** Returns a lower bound of the output's bytes for a grid of this shape. */
    long leastBytes(GridShape shape);

    default long bytes(ColorGrid grid) {
        return leastBytes(grid.shape());
    }

    /** Returns the shape, enlarged where the format needs it. */
    default GridShape fit(GridShape shape) {
        return shape;
    }

    /** Returns how many numbers of a table are in memory at once. */
    default long numbers(GridShape shape) {
        return ColorGrid.CHANNELS * shape.allTexels();
    }

    /** Returns the weights over wavelength with which errors are measured. */
    default CieTable errorWeights(CieTable light) {
        return light;
    }

    /** Returns the grid as it is after writing and reading, for example rounded to half floats. */
    default ColorGrid asRead(ColorGrid grid) {
        return grid;
    }

    /** Returns the errors that are judged by the tolerance. */
    default ErrorStatistics errors(TableMetadata metadata) {
        return metadata.errors().sums();
    }

    default List<String> notes() {
        return List.of();
    }

    /** Returns the contents of the files by ending; of a format that is one file, one content. */
    Map<String, AtomicFile.StreamContent> files(ColorGrid grid, GridBaker baker, TableMetadata metadata);
}
