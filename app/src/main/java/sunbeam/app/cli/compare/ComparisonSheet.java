package sunbeam.app.cli.compare;

import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.ColorMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.render.SceneDisplay;
import sunbeam.app.render.ScenePicture;
import sunbeam.app.scene.SceneColor;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;

/** Picture of a comparison: photograph and scene, below them a map of their difference and histograms of their hues. */
final class ComparisonSheet {
    private static final int PANEL = 720;
    private static final int MARGIN = 24;
    /** Pixels to the left and right of a map's cells for axes and color bar. */
    private static final int MAP_BESIDE = 190;

    private static final int MAP_ABOVE = 130;
    private static final int LEAST_PLOT = 420;
    // Least upper end of the color scale, CIEDE2000: a scale that ends below visible differences would show rounding.
    private static final double LEAST_SCALE = 1;

    private ComparisonSheet() {}

    static BufferedImage draw(
            ScenePicture photo, ScenePicture scene, PhotoComparison comparison, SceneColor background) {
        int height = Math.max(1, PANEL * photo.height() / photo.width());
        int plots = Math.max(LEAST_PLOT, (PANEL - MAP_BESIDE) * photo.height() / photo.width() + MAP_ABOVE);
        Sheet sheet = new Sheet(2 * (MARGIN + PANEL))
                .part(MARGIN, graphics -> {
                    graphics.drawString("Photograph", MARGIN, MARGIN - 6);
                    graphics.drawString(
                            "The scene's mesh, at the photograph's exposure", 2 * MARGIN + PANEL, MARGIN - 6);
                })
                .part(height, graphics -> {
                    graphics.setRenderingHint(
                            RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
                    graphics.drawImage(shown(photo, 1, background), MARGIN, 0, PANEL, height, null);
                    graphics.drawImage(
                            shown(scene, comparison.exposure(), background),
                            2 * MARGIN + PANEL,
                            0,
                            PANEL,
                            height,
                            null);
                })
                .row(difference(photo, comparison, plots), hues(comparison.hue(), plots));
        comparison.lines().forEach(line -> sheet.text(line, Sheet.FONT));
        return sheet.draw();
    }

    private static BufferedImage shown(ScenePicture picture, double exposure, SceneColor background) {
        return SceneDisplay.image(picture, 1, new DisplayTransform(exposure, Tone.CLIP), background);
    }

    private static BufferedImage difference(ScenePicture photo, PhotoComparison comparison, int height) {
        int columns = photo.width();
        double[][] rows = new double[photo.height()][columns];
        for (int row = 0; row < rows.length; row++) {
            // The heat map's rows begin at the bottom.
            System.arraycopy(comparison.differences(), (rows.length - 1 - row) * columns, rows[row], 0, columns);
        }
        HeatMap.Values values = new HeatMap.Values(
                rows,
                new double[] {0, columns},
                new double[] {0, rows.length},
                new HeatMap.Colors(
                        "CIEDE2000", 0, Math.max(LEAST_SCALE, comparison.high()), Plot.Scale.LINEAR, ColorMap.VIRIDIS),
                HeatMap.Reduction.MIDDLE);
        return new HeatMap(
                        new HeatMap.Frame(
                                "Difference, to its 95th percentile",
                                "column",
                                "row from below",
                                PANEL + MARGIN,
                                height,
                                true),
                        values)
                .draw();
    }

    private static BufferedImage hues(PhotoComparison.HueComparison hue, int height) {
        double[] degrees = IntStream.range(0, hue.first().length)
                .mapToDouble(step -> PhotoComparison.HueComparison.STEP_DEGREES * (step + 0.5))
                .toArray();
        return Plot.linear(
                        "Hues of colored pixels",
                        "hue h* / degrees (0 red, 90 yellow, 180 green, 270 blue)",
                        "share of pixels per 10 degrees",
                        PANEL + MARGIN,
                        height)
                .legendBelow()
                .line("photograph", degrees, hue.first())
                .line("scene", degrees, hue.second())
                .draw();
    }
}
