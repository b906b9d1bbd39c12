package sunbeam.app.measure.accuracy;

import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.output.Overwrite;

/** What an experiment comes to: a plot, a table, and what must be said beside them. */
interface Figure {

    /** Part of the file names: lower-case letters. */
    String key();

    /** Above the plot. */
    String title();

    /** Whole sentences, such as what could not be measured and why. */
    List<String> remarks();

    /** The plot as PNG. */
    void writePlot(Path file, Overwrite overwrite);

    /** The table as CSV. */
    void writeTable(Path file, Overwrite overwrite);
}
