package sunbeam.app.cli.render;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import jrtr.GraphicsException;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Option;
import sunbeam.app.cli.Certificate;
import sunbeam.app.cli.CertifyOption;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.cli.PictureSize;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.LinearFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.TevClient;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.render.DrawRequest;
import sunbeam.app.render.FrameText;
import sunbeam.app.render.LightCone;
import sunbeam.app.render.LightCount;
import sunbeam.app.render.LineDrawings;
import sunbeam.app.render.PartSum;
import sunbeam.app.render.PixelPicture;
import sunbeam.app.render.PixelPicture.LitPixels;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.ScenePicture;
import sunbeam.app.render.SceneSession;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.work.Progress;

/** Draws frames, tile by tile, and writes each as soon as it is finished. */
public final class FrameSequence implements AutoCloseable {
    // Tolerance of the exact points of a certificate: a quarter of the limit of the picture's median error.
    private static final double POINT_TOLERANCE = 5e-3;

    private final RenderContext context;
    private final Environment environment;
    private final List<SceneSession> sessions;
    private final PartSum sum;
    private final int width;
    private final int height;
    private final PixelSamples samples;
    private final Overlays overlays;
    private final TevClient viewer;
    private final FrameText text;
    private double exposure = 1;
    private Optional<LitPixels> lit = Optional.empty();

    /** Prepares to draw frames of the scene that these sessions, which it closes, hold together; {@code viewer} may be null. */
    public FrameSequence(
            RenderContext context,
            List<SceneSession> sessions,
            PictureSize size,
            PixelSamples samples,
            Overlays overlays,
            TevClient viewer,
            Environment environment) {
        this.context = context;
        this.environment = environment;
        this.sessions = List.copyOf(sessions);
        this.sum = new PartSum(sessions);
        this.width = size.width();
        this.height = size.height();
        this.samples = samples;
        this.overlays = overlays;
        this.viewer = viewer;
        this.text = new FrameText(parts(), width, height, samples, overlays.describe());
    }

    public List<SceneData> parts() {
        return sessions.stream().map(SceneSession::data).toList();
    }

    /** Returns the number of lights that stand for a scene's environment; empty if that is not open. */
    Optional<LightCount> lightCount(Scene scene) {
        return LightCount.of(sum, scene, width, height, () -> false);
    }

    /** Returns whether the frame's file is missing or has other parameters; throws an exception if it must not be replaced. */
    private boolean isMissing(Scene scene, Path file, Overwrite overwrite) {
        boolean missing = PngText.find(file, text.identity(scene)).isEmpty();
        if (missing && overwrite == Overwrite.REFUSE && Files.exists(file)) {
            throw new OutputException.Exists(
                    "cannot write " + file + ": it exists with other parameters; add --force to replace it");
        }
        return missing;
    }

    /**
     * Draws the frames, to resume only the missing ones, with the first one's exposure, so that an animation does not flicker, and returns
     * their files. A single frame, even if it is not missing, may have a file for its linear colors, else null.
     */
    List<Path> draw(List<Scene> scenes, List<Path> files, boolean resume, Overwrite overwrite, Path linear) {
        List<Boolean> missing = IntStream.range(0, files.size())
                .mapToObj(i -> !resume || isMissing(scenes.get(i), files.get(i), overwrite))
                .toList();
        List<Path> places = new ArrayList<>(files);
        int first = linear == null ? missing.indexOf(true) : 0;
        if (first < 0) {
            return places;
        }
        String recorded = missing.get(0) ? "" : PngText.read(files.get(0)).getOrDefault("Exposure", "");
        exposure = Decimals.parse(recorded)
                .orElseGet(() -> sum.exposure(scenes.get(first), width, height, TimedTiles.large(), () -> false)
                        .orElseThrow());
        try (Progress progress = start(Collections.frequency(missing, true))) {
            for (int i = first; i < scenes.size(); i++) {
                if (missing.get(i) || linear != null) {
                    places.set(i, draw(scenes.get(i), files.get(i), missing.get(i), overwrite, linear, progress));
                }
            }
        }
        return places;
    }

    private Progress start(long frames) {
        return environment.progress().start("rendering", frames * width * height);
    }

    public ScenePicture light(Scene scene) {
        ScenePicture picture = ScenePicture.empty(width, height);
        int side = samples.side();
        try (Progress progress = start(1)) {
            drawTiles(progress, tile -> {
                ScenePicture drawn = sum.draw(DrawRequest.ofPixels(scene, width, height, tile, side));
                picture.put(drawn.reduced(side), tile.x(), tile.y());
            });
        }
        return picture;
    }

    private void drawTiles(Progress progress, Consumer<Tile> drawing) {
        for (Tile tile : SceneSession.tiles(width, height, samples.side())) {
            drawing.accept(tile);
            progress.step(tile.pixels());
        }
        sum.validate();
    }

    private Path draw(Scene scene, Path file, boolean missing, Overwrite overwrite, Path linear, Progress progress) {
        // The linear picture takes the memory of four images, so it is made only if it is written.
        ScenePicture picture = linear == null ? null : ScenePicture.empty(width, height);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        DisplayTransform display = scene.display(exposure);
        if (viewer != null) {
            viewer.create(file.toString(), width, height);
        }
        drawTiles(progress, tile -> {
            PixelPicture drawn = sum.draw(scene, width, height, tile, samples, exposure);
            image.getRaster().setDataElements(tile.x(), tile.y(), drawn.image().getRaster());
            ScenePicture pixels = drawn.light();
            if (missing) {
                lit = Optional.of(lit.orElse(LitPixels.NONE).plus(LitPixels.of(pixels, display)));
            }
            if (picture != null) {
                picture.put(pixels, tile.x(), tile.y());
            }
            if (viewer != null) {
                float[] xyz = pixels.linear().xyz();
                viewer.update(file.toString(), tile.x(), tile.y(), tile.width(), tile.height(), xyz);
            }
        });
        if (linear != null) {
            AtomicFile.write(
                    linear, overwrite, LinearFile.of(linear, picture.linear().xyz(), width, height));
        }
        if (!missing) {
            return file;
        }
        overlays.paint(image, scene, sessions.get(0));
        return PngWriter.write(
                file, overwrite, image, text.of(scene, exposure, context.info().renderer()));
    }

    /** Compares random pixels with points of the scene by method full, and returns the exit code that the picture deserves. */
    ExitCode certify(Scene scene, int count, Map<String, Object> report, PrintWriter out, PrintWriter err) {
        var certifier = new Certificate.SceneCertifier(width, height, samples, environment.progress());
        List<SceneSession> exact = new ArrayList<>();
        try {
            Certificate certificate;
            if (scene.hasEnvironment() && scene.method().isTable()) {
                certificate = certifier.certify(sum, scene, sum, LightCount.finest(scene), exposure, count);
            } else {
                Scene points = scene.withMethod(scene.method()
                        .with(Choices.none()
                                .with(Methods.METHOD, FullMethod.TYPE)
                                .with(TOLERANCE, POINT_TOLERANCE)));
                List<SceneData> parts = new SceneLoader(environment, warning -> {}).parts(points, parts(), share -> {});
                exact.addAll(SceneSession.all(context, parts));
                Scene drawn = parts.get(0).scene();
                certificate = certifier.certify(sum, scene, new PartSum(exact), drawn, exposure, count);
            }
            report.put("certificate", JsonOption.fields(certificate));
            // A larger --supersample does not reduce the errors of the table at the footprints of these pixels.
            List<ErrorStatistics> tables = sessions.stream()
                    .flatMap(part -> part.tableErrors(scene, width, height, samples).stream())
                    .toList();
            tables.forEach(errors -> out.println("table: " + errors + " at " + errors.count() + " samples"));
            double tolerance = scene.method().get(TOLERANCE);
            Optional<String> miss = tables.stream()
                    .flatMap(errors -> VirtualTexture.miss(errors, tolerance).stream())
                    .findFirst();
            boolean isTable = scene.method().isTable();
            String remedy = miss.orElse(
                    "a larger --supersample or --size" + (isTable ? "" : ", or --method table,") + " may help");
            ExitCode judged = CertifyOption.judge(certificate, true, remedy, out, err);
            if (judged == ExitCode.OK && miss.isPresent()) {
                err.println(Messages.error(miss.get()));
                return ExitCode.TOLERANCE_MISSED;
            }
            return judged;
        } catch (GraphicsException failure) {
            throw new GraphicsException("the picture is written, but cannot be compared: " + failure.getMessage()
                    + "; or leave --certify out");
        } finally {
            exact.forEach(SceneSession::close);
        }
    }

    /** Returns the lit pixels of all drawn frames; empty if no frame was drawn. */
    Optional<LitPixels> lit() {
        return lit;
    }

    @Override
    public void close() {
        sessions.forEach(SceneSession::close);
    }

    /** Options {@code --light-cone} and {@code --strokes}, drawings over a picture; a picocli mixin. */
    public static final class Overlays {
        @Option(
                names = "--light-cone",
                description = "Also draw a cone from the middle of the picture towards the light, as the viewer does.")
        boolean lightCone;

        @Option(
                names = "--strokes",
                description =
                        "Also draw the direction of the nanostructure: dots on the skin, each with a stroke along the patch's x axis. With --wireframe, strokes along the vertices' normals.")
        boolean strokes;

        /** Returns words for the picture's identity, by which {@code --resume} recognizes it. */
        String describe() {
            return (lightCone ? ", cone" : "") + (strokes ? ", strokes" : "");
        }

        void paint(BufferedImage image, Scene scene, SceneSession session) {
            if (strokes) {
                session.update(scene);
                LineDrawings.strokes(image.createGraphics(), session, image.getWidth(), image.getHeight());
            }
            if (lightCone) {
                LightCone.of(scene).paint(image.createGraphics(), image.getWidth(), image.getHeight());
            }
        }
    }
}
