package sunbeam.app.cli.render;

import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import sunbeam.app.cli.FileCommand;
import sunbeam.app.cli.PictureSize;
import sunbeam.app.cli.SettingOptions;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.ColorMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.render.PixelPicture;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneLoader.LoadingScene;
import sunbeam.app.render.ScenePicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Command {@code sunbeam compare}: compares a photograph with a scene that describes it. */
@Command(
        name = "compare",
        header = "Compare a photograph with a scene.",
        description = "Draw a scene at a photograph's size, fit one factor of exposure, and state the difference of"
                + " colors on the mesh. Writes one PNG: photograph, scene, CIEDE2000 of each pixel, histograms of"
                + " hue. The scene must describe camera, light and mesh of the photograph. Less than 5 %% of the mesh lit is"
                + " exit code 3. For a goniometer's table use docs/examples/compare_goniometer.py.",
        footer = {"  sunbeam compare photo.tif scene.json"})
public final class CompareCommand extends FileCommand {
    private static final int PANEL = Drawing.COLUMN / 2 - 48;
    private static final int MARGIN = 48;
    /** Pixels to the left and right of a map's cells for axes and color bar. */
    private static final int MAP_BESIDE = 250;

    private static final int MAP_ABOVE = 200;
    private static final int LEAST_PLOT = 560;
    // Least upper end of the color scale, CIEDE2000: a scale that ends below visible differences would show rounding.
    private static final double LEAST_SCALE = 1;
    // Most pixels of the longer side by default; at a photograph's own size drawing would take an hour.
    private static final int LONGER_SIDE = 1024;
    private static final double LARGEST_FACTOR = 1e12;

    @Parameters(
            index = "0",
            paramLabel = "PHOTO",
            description = "PNG, JPEG or TIFF of 8 or 16 bits and at most 160 million pixels, upright by its Exif"
                    + " orientation; colors by its ICC profile, sRGB without one. Transparent pixels are left out.")
    private Path photo;

    @Parameters(
            index = "1",
            paramLabel = "SCENE",
            completionCandidates = SceneOverrides.Names.class,
            description = "A built-in scene (${COMPLETION-CANDIDATES}) or a scene file (.json; docs/scenes.md).")
    private String sceneName;

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description = "The picture. Default: the photograph's name with -compared.")
    private Path output;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description = "Size to which the photograph is reduced, and of the drawn scene, with the photograph's"
                    + " ratio of sides. Default: the photograph's size, with a longer side of 1024 pixels at most.")
    private PictureSize size;

    @Option(
            names = "--factor",
            paramLabel = "F",
            description =
                    "The scene's exposure, a factor of its light. Default: fitted by least squares with Huber's weights.")
    private Double factor;

    /** Not exposure, tone and primaries: the exposure is fitted, and a camera without a tone curve is assumed. */
    @Mixin
    private final SettingOptions overrides = SettingOptions.overriding(
            SceneOverrides.SETTINGS.stream()
                    .filter(setting -> !List.of(SceneSettings.EXPOSURE, SceneSettings.TONE, SceneSettings.PRIMARIES)
                            .contains(setting))
                    .toList(),
            SceneOverrides.STANDARDS);

    @Override
    public Integer call() {
        Ending.PNG.require("--output", output);
        if (factor != null && !(factor > 0 && factor <= LARGEST_FACTOR)) {
            throw new UsageException(
                    "--factor " + Decimals.format(factor) + " is out of range; give a number above 0 to 1e12");
        }
        Scene scene = SceneOverrides.apply(Scenes.load(sceneName), overrides.choices());
        Path target = output != null ? output : Path.of(FileNames.stem(photo) + "-compared.png");
        AtomicFile.checkWritable(target, overwrite(output));
        Photograph photograph = Photograph.read(photo);
        PictureSize drawn = size(photograph);
        SceneLoader loader = new SceneLoader(environment(), warning -> err().println(Messages.warning(warning)));
        Photograph.Linear linear = photograph.reduced(drawn.width(), drawn.height());
        ScenePicture picture = draw(loader, scene, drawn);
        PhotoComparison comparison = PhotoComparison.of(linear, picture, Optional.ofNullable(factor));
        Drawing sheet = sheet(linear.picture(), picture, comparison, scene.background());
        String sizes = Text.oneLine(photo.getFileName().toString()) + ", " + photograph.width() + "x"
                + photograph.height() + (drawn.width() == photograph.width() ? "" : " reduced to " + drawn);
        String caption = SceneWriter.caption(scene);
        String lines = String.join("\n", comparison.lines());
        Map<String, String> text = new TreeMap<>(
                Map.of("Title", "Photograph and scene", "Photograph", sizes, "Scene", caption, "Comparison", lines));
        Path written = PngWriter.write(target, overwrite(output), sheet.rasterize(), text);
        Map<String, Object> values = new LinkedHashMap<>(Map.of("photograph", sizes));
        values.putAll(comparison.values());
        PrintWriter out = out(output);
        json.text(out).println("photograph: " + sizes);
        comparison.lines().forEach(json.text(out)::println);
        json.print(out, values, List.of(written));
        if (comparison.lit().areTooFew()) {
            err().println(Messages.warning(comparison.lit().complaint()));
            return ExitCode.TOLERANCE_MISSED.code();
        }
        return ExitCode.OK.code();
    }

    private ScenePicture draw(SceneLoader loader, Scene scene, PictureSize size) {
        PixelSamples samples = PixelSamples.of(scene.method(), size.width(), size.height());
        try (LoadingScene loading = new LoadingScene(loader, scene);
                RenderContext context = loading.offscreen();
                FrameSequence frames = new FrameSequence(
                        context,
                        loading.upload(context),
                        size,
                        samples,
                        new FrameSequence.Overlays(),
                        null,
                        environment())) {
            err().println("plan: " + frames.parts().get(0).method().summary());
            return frames.light(scene);
        }
    }

    private PictureSize size(Photograph photograph) {
        int width = photograph.width();
        int height = photograph.height();
        int longer = Math.min(LONGER_SIDE, Math.max(width, height));
        if (size == null) {
            return fitting(width, height, (double) longer / Math.max(width, height));
        }
        if (size.width() > width || size.height() > height) {
            throw new UsageException("--size " + size + " is larger than the photograph, " + width + "x" + height
                    + "; give less, or leave it out");
        }
        PictureSize right = fitting(width, height, (double) size.width() / width);
        if (Math.abs(right.height() - size.height()) > 1) {
            throw new UsageException("--size " + size + " has another ratio of sides than the photograph, " + width
                    + "x" + height + "; give " + right);
        }
        return size;
    }

    private static PictureSize fitting(int width, int height, double scale) {
        return new PictureSize(
                (int) Math.max(1, Math.round(scale * width)), (int) Math.max(1, Math.round(scale * height)));
    }

    /** Picture of a comparison: photograph and scene, below them a map of their difference and histograms of their hues. */
    private static Drawing sheet(
            ScenePicture photo, ScenePicture scene, PhotoComparison comparison, SceneColor background) {
        int height = Math.max(1, PANEL * photo.height() / photo.width());
        int plots = Math.max(LEAST_PLOT, (PANEL - MAP_BESIDE) * photo.height() / photo.width() + MAP_ABOVE);
        Sheet sheet = new Sheet(2 * (MARGIN + PANEL))
                .part(MARGIN, graphics -> {
                    graphics.drawString("Photograph", MARGIN, MARGIN - 14);
                    graphics.drawString("Mesh, at the photograph's exposure", 2 * MARGIN + PANEL, MARGIN - 14);
                })
                .part(height, graphics -> {
                    graphics.setRenderingHint(
                            RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
                    graphics.drawImage(shown(photo, 1, background), MARGIN, 0, PANEL, height, null);
                    BufferedImage drawn = shown(scene, comparison.exposure(), background);
                    graphics.drawImage(drawn, 2 * MARGIN + PANEL, 0, PANEL, height, null);
                })
                .row(difference(photo, comparison, plots), hues(comparison.hue(), plots));
        comparison.lines().forEach(line -> sheet.text(line, Sheet.FONT));
        return sheet.draw();
    }

    private static BufferedImage shown(ScenePicture picture, double exposure, SceneColor background) {
        return PixelPicture.image(picture, new DisplayTransform(exposure, Tone.CLIP), background);
    }

    private static Drawing difference(ScenePicture photo, PhotoComparison comparison, int height) {
        int columns = photo.width();
        double[][] rows = new double[photo.height()][columns];
        for (int row = 0; row < rows.length; row++) {
            // The heat map's rows begin at the bottom.
            System.arraycopy(comparison.differences(), (rows.length - 1 - row) * columns, rows[row], 0, columns);
        }
        String title = "Difference, to its 95th percentile";
        HeatMap.Frame frame = new HeatMap.Frame(title, "column", "row from below", PANEL + MARGIN, height, true);
        double high = Math.max(LEAST_SCALE, comparison.high());
        HeatMap.Colors colors = new HeatMap.Colors("CIEDE2000", 0, high, Plot.Scale.LINEAR, ColorMap.VIRIDIS);
        double[] across = {0, columns};
        double[] up = {0, rows.length};
        return new HeatMap(frame, new HeatMap.Values(rows, across, up, colors, HeatMap.Reduction.MIDDLE)).draw();
    }

    private static Drawing hues(PhotoComparison.HueComparison hue, int height) {
        double[] degrees = IntStream.range(0, hue.first().length)
                .mapToDouble(step -> PhotoComparison.HueComparison.STEP_DEGREES * (step + 0.5))
                .toArray();
        String x = "hue h* / degrees";
        return Plot.linear("Hues of colored pixels", x, "share of pixels per degree", PANEL + MARGIN, height)
                .line("photograph", degrees, perDegree(hue.first()))
                .line("scene", degrees, perDegree(hue.second()))
                .draw();
    }

    private static double[] perDegree(double[] shares) {
        return Arrays.stream(shares)
                .map(share -> share / PhotoComparison.HueComparison.STEP_DEGREES)
                .toArray();
    }
}
