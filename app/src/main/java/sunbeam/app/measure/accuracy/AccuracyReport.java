package sunbeam.app.measure.accuracy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.measure.accuracy.ReferenceSamples.SampleCounts;

/** The figures of some patches as files: a plot and a table each, and a page that shows them all. */
final class AccuracyReport {
    private final Path folder;
    private final Overwrite overwrite;
    private final Map<String, String> patches;
    private boolean written;
    private final Map<String, List<Figure>> figures = new LinkedHashMap<>();

    /** @param patches by name: what they are */
    AccuracyReport(Path folder, Overwrite overwrite, Map<String, String> patches) {
        this.patches = patches;
        this.folder = folder;
        this.overwrite = overwrite;
    }

    /** The page. */
    Path file() {
        return folder.resolve("README.md");
    }

    /** Tells before the work begins whether the page can be written. */
    void checkWritable() {
        AtomicFile.checkWritable(file(), overwrite);
    }

    /** Writes a figure's plot and table, and keeps it for the page. */
    void add(String patch, Figure figure) {
        String stem = AccuracyPage.stem(patch, figure);
        figure.writeTable(folder.resolve(stem + ".csv"), overwrite);
        figure.writePlot(folder.resolve(stem + ".png"), overwrite);
        figures.computeIfAbsent(patch, name -> new ArrayList<>()).add(figure);
    }

    /** Writes the page, in place of an earlier one of this run. */
    void write(SampleCounts counts, String renderer) {
        String page = new AccuracyPage(patches, figures, counts, renderer).text();
        AtomicFile.write(
                file(),
                written ? Overwrite.REPLACE : overwrite,
                stream -> stream.write(page.getBytes(StandardCharsets.UTF_8)));
        written = true;
    }
}
