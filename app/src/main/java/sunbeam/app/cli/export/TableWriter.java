package sunbeam.app.cli.export;

import java.util.List;
import java.util.Map;
import sunbeam.app.files.output.StreamContent;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.ErrorStatistics;

/** Converts a color grid to the files of one format. */
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

    Output output(ColorGrid grid, GridBaker baker, TableMetadata metadata);

    /** Files by ending (one, of a format that is one file), lines to print, and the errors that the tolerance judges. */
    record Output(Map<String, StreamContent> files, List<String> notes, ErrorStatistics errors) {
        Output(Map<String, StreamContent> files, TableMetadata metadata) {
            this(files, List.of(), metadata.errors().sums());
        }
    }
}
