package sunbeam.app.measure.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.measure.accuracy.MethodsFigure.Entry;
import sunbeam.app.measure.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.measure.errors.ErrorStatistics;

final class AccuracyReportTest {
    private static final SampleCounts COUNTS = new SampleCounts(40, 10, 3);
    private static final Map<String, String> PATCHES = Map.of("ramp", "4 x 2 samples, 2 um x 2 um");

    @TempDir
    private Path folder;

    private static ErrorFigure tolerances() {
        ErrorCurve power = new ErrorCurve(
                "power",
                List.of(1e-3, 1e-2),
                List.of(new ErrorStatistics(40, 2e-3, 2.5e-3, 1), new ErrorStatistics(40, 2e-3, 2.9e-2, 1)));
        ErrorCurve thesis = ErrorCurve.point("thesis power", 1e-2, new ErrorStatistics(20, 0.1, 0.4, 8));
        return new ErrorFigure(
                "tolerance",
                "ramp: error over tolerance",
                Axis.logarithmic("tolerance"),
                "relative error",
                "tolerance",
                List.of(power),
                List.of(thesis),
                ErrorFigure.Style.AGAINST_TOLERANCE,
                List.of("Tolerance 1e-5 was not measured: no memory."));
    }

    private static MethodsFigure methods() {
        return new MethodsFigure(
                "ramp",
                List.of(
                        new Entry("full, thesis", new ErrorStatistics(10, 0.1, 0.4, 1), 120, MethodsFigure.FULL),
                        new Entry(
                                "full, tolerance 1e-3", new ErrorStatistics(10, 4e-4, 1e-3, 1), 12, MethodsFigure.FULL),
                        new Entry("gem", new ErrorStatistics(10, 1, 4, 1e9), 0.1, "a grating's spacing")),
                List.of());
    }

    private String page() throws IOException {
        return Files.readString(folder.resolve("README.md"));
    }

    @Test
    void theVerdictFollowsMedianAndPercentile() throws IOException {
        AccuracyReport report = new AccuracyReport(folder, Overwrite.REFUSE, PATCHES);
        report.add("ramp", tolerances());
        report.write(COUNTS, "renderer");

        assertThat(page().lines())
                .contains(
                        "| ramp | power | 1e-3 | 40 | 2.0e-03 | 2.5e-03 | 1.0e+00 | **missed** |",
                        "| ramp | power | 1e-2 | 40 | 2.0e-03 | 2.9e-02 | 1.0e+00 | kept |",
                        "- ramp: 4 x 2 samples, 2 um x 2 um",
                        "Tolerance 1e-5 was not measured: no memory.");
    }

    @Test
    void methodsAreComparedWithTheThesissTime() throws IOException {
        AccuracyReport report = new AccuracyReport(folder, Overwrite.REFUSE, PATCHES);
        report.add("ramp", methods());
        report.write(COUNTS, "renderer");

        assertThat(page().lines())
                .contains(
                        "| ramp | full, tolerance 1e-3 | 4.0e-04 | 1.0e-03 | 12.0 | 10.0 |  |",
                        "| ramp | gem | 1.0e+00 | 4.0e+00 | 0.100 | 1200 | a grating's spacing |");
        assertThat(Files.readAllLines(folder.resolve("ramp-methods.csv")))
                .containsExactly(
                        "method,directions,XYZ median,XYZ p95,XYZ maximum,us per pixel,times faster than thesis",
                        "full thesis,10,1.0000e-01,4.0000e-01,1.0000e+00,120.0,1.000",
                        "full tolerance 1e-3,10,4.0000e-04,1.0000e-03,1.0000e+00,12.00,10.00",
                        "gem,10,1.0000e+00,4.0000e+00,1.0000e+09,0.1000,1200");
    }

    @Test
    void everyFigureHasItsPlotAndItsTableNextToThePage() throws IOException {
        AccuracyReport report = new AccuracyReport(folder, Overwrite.REFUSE, PATCHES);
        report.add("ramp", tolerances());
        report.add("ramp", methods());
        report.write(COUNTS, "renderer");
        for (String stem : List.of("ramp-tolerance", "ramp-methods")) {
            assertThat(page()).contains("(" + stem + ".png)").contains("(" + stem + ".csv)");
            assertThat(ImageIO.read(folder.resolve(stem + ".png").toFile()).getWidth())
                    .isPositive();
            assertThat(folder.resolve(stem + ".csv")).isNotEmptyFile();
        }
    }

    @Test
    void thePageGrowsDuringARunButAnEarlierRunsPageStays() throws IOException {
        AccuracyReport report = new AccuracyReport(folder, Overwrite.REFUSE, PATCHES);
        report.add("ramp", tolerances());
        report.write(COUNTS, "renderer");
        report.add("ramp", methods());
        report.write(COUNTS, "renderer");
        assertThat(page()).contains("ramp-methods.png");

        AccuracyReport later = new AccuracyReport(folder, Overwrite.REFUSE, PATCHES);
        assertThatThrownBy(later::checkWritable).isInstanceOf(OutputException.class);
    }
}
