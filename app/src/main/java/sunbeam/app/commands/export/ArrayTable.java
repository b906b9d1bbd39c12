package sunbeam.app.commands.export;

import java.nio.file.Path;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.color.CieTable;

/** Files that hold C as an array with channels of one's choice. */
interface ArrayTable extends TableWriter {
    String INTERPOLATION =
            "square roots (of negative values, minus that of the absolute) linear along u and v; their squares by the"
                    + " cubic polynomial through the four nearest slices of w";

    Channels channels();

    Ending ending();

    @Override
    default void check(Path output, Overwrite overwrite) {
        ending().require("--output", output);
        AtomicFile.checkWritable(output, overwrite);
    }

    @Override
    default long numbers(GridShape shape) {
        return channels().numbers(shape);
    }

    @Override
    default CieTable measured(CieTable light) {
        return channels().measured(light);
    }
}
