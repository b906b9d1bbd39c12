package sunbeam.app.accuracy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.Overwrite;

/** The figures of some patches as files: a plot and a table each, and a page that shows them all. */
final class AccuracyReport {
    private final Path folder;
    private final Overwrite overwrite;
    private final Map<String, List<ErrorFigure>> figures = new LinkedHashMap<>();

    AccuracyReport(Path folder, Overwrite overwrite) {
        this.folder = folder;
        this.overwrite = overwrite;
    }

    Path file() {
        return folder.resolve("README.md");
    }

    /** Tells before the work begins whether its report can be written. */
    void checkWritable() {
        AtomicFile.checkWritable(file(), overwrite);
    }

    /** Writes a figure's plot and table, and keeps it for the page. */
    void add(Subject subject, ErrorFigure figure) {
        String stem = stem(subject.name(), figure);
        figure.writeTable(folder.resolve(stem + ".csv"), overwrite);
        figure.writePlot(folder.resolve(stem + ".png"), overwrite);
        figures.computeIfAbsent(subject.name(), name -> new ArrayList<>()).add(figure);
    }

    private static String stem(String patch, ErrorFigure figure) {
        return patch + "-" + figure.key();
    }

    void write(SampleCounts counts, String renderer) {
        StringBuilder page = new StringBuilder();
        for (Map.Entry<String, List<ErrorFigure>> patch : figures.entrySet()) {
            for (ErrorFigure figure : patch.getValue()) {
                if (figure.key().equals("tolerance")) {
                    for (ErrorCurve curve : figure.curves()) {
                        for (int i = 0; i < curve.x().size(); i++) {
                            ErrorStatistics errors = curve.errors().get(i);
                            page.append(String.format(
                                    Locale.ROOT,
                                    "| %s | %s | %.0e | %s | %s |%n",
                                    patch.getKey(),
                                    curve.name(),
                                    curve.x().get(i),
                                    errors,
                                    errors.meets(curve.x().get(i)) ? "met" : "MISSED"));
                        }
                    }
                    for (ErrorCurve curve : figure.thesis()) {
                        page.append(patch.getKey() + " " + curve.name() + " " + curve.errors() + "\n");
                    }
                }
            }
        }
        byte[] bytes = page.toString().getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(file(), overwrite, stream -> stream.write(bytes));
    }
}
