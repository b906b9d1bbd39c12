package sunbeam.app.commands.figures;

import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.commands.evaluate.Evaluation;
import sunbeam.app.commands.evaluate.GratingRequest;
import sunbeam.app.commands.figures.Panel.ResponsePanel;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.PeriodStatistics;

/** Evaluates a patch by the grating equation and draws its response. */
final class ResponseDrawer {
    /** Keyword of the PNG's text that holds the row of Table 4.1. */
    static final String ROW = "Table 4.1";

    private final FigurePatches patches;
    private final PanelStore store;

    ResponseDrawer(FigurePatches patches, PanelStore store) {
        this.patches = patches;
        this.store = store;
    }

    /** Draws and writes a response; returns the texts of its picture. */
    Map<String, String> draw(ResponsePanel panel) {
        Evaluation evaluation = Evaluation.ofRadiance(
                patches.setup(panel.role()), GratingRequest.ofThesis(patches.azimuth(panel.role())), panel.choices());
        GratingMeasurement measurement = evaluation
                .measurement()
                .orElseThrow(() -> new IllegalStateException("the thesis's window tells its gratings' orders apart"));
        BufferedImage plot = evaluation.plot();
        Map<String, String> text = new LinkedHashMap<>();
        text.put(
                PanelStore.CAPTION,
                panel.label()
                        + String.format(
                                Locale.ROOT,
                                "; azimuth %.2f degrees, 401 wavelengths, 1500 angles; period %.2f nm",
                                Math.toDegrees(evaluation.azimuth()),
                                measurement.fittedPeriod() * 1e9));
        text.put(ROW, row(panel, evaluation.azimuth(), measurement));
        return store.write(panel, plot, text);
    }

    /** Patch, azimuth in degrees, then mean (nm) and variance (nm^2) on samples, and the same interpolated. */
    private static String row(ResponsePanel panel, double azimuth, GratingMeasurement measurement) {
        PeriodStatistics sampled = measurement.sampled();
        PeriodStatistics interpolated = measurement.interpolated();
        return String.format(
                Locale.ROOT,
                "%s,%.2f,%.2f,%.3f,%.2f,%.3f",
                panel.role().label(),
                Math.toDegrees(azimuth),
                sampled.mean() * 1e9,
                sampled.variance() * 1e18,
                interpolated.mean() * 1e9,
                interpolated.variance() * 1e18);
    }
}
