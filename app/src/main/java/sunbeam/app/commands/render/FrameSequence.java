package sunbeam.app.commands.render;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import jrtr.RenderContext;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.app.measure.errors.CertifyOption;
import sunbeam.app.measure.errors.CrawlCertificate;
import sunbeam.app.measure.errors.SceneCertificate;
import sunbeam.app.measure.errors.SceneCertifier;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.units.Decimals;

/** Draws frames and writes each as soon as it is finished. */
final class FrameSequence implements AutoCloseable {
    private final SceneData data;
    private final PictureSize size;
    private final int supersample;
    private final String renderer;
    private final FrameIdentity identity;
    private final List<SceneSession> sessions = new ArrayList<>();
    private double lastExposure = 1;
    private boolean drawn;
    private boolean light;

    /** @param parts whose light adds up; most scenes are one */
    FrameSequence(RenderContext context, List<SceneData> parts, PictureSize size, int supersample) {
        this.data = parts.get(0);
        this.size = size;
        this.supersample = supersample;
        this.renderer = context.info().renderer();
        this.identity = new FrameIdentity(data, size, supersample);
        try {
            parts.forEach(part -> sessions.add(new SceneSession(context, part)));
        } catch (RuntimeException | OutOfMemoryError failure) {
            close();
            throw failure;
        }
    }

    /** What tells the frames apart. */
    List<String> identities(List<Scene> scenes) {
        return scenes.stream().map(identity::of).toList();
    }

    /**
     * Draws the frames that are missing. Where exposure is automatic, the first frame's holds for all, so that an
     * animation does not flicker.
     *
     * @param linear where the linear colors of the only frame go, or null
     * @return where the frames are
     */
    List<Path> draw(List<Scene> scenes, List<Path> files, List<Boolean> missing, Overwrite overwrite, Path linear) {
        long frames = Collections.frequency(missing, true);
        OptionalDouble recorded = missing.get(0) ? OptionalDouble.empty() : recordedExposure(files.get(0));
        List<Path> places = new ArrayList<>(files);
        FrameRenderer frameRenderer = new FrameRenderer(new PartSum(sessions), size, supersample);
        int first = linear == null ? missing.indexOf(true) : 0;
        double factor = lastExposure;
        if (first >= 0) {
            // Before the rest: the time that its colors take says nothing of how long pixels do.
            factor = recorded.isPresent() ? recorded.getAsDouble() : frameRenderer.exposure(scenes.get(first));
            frameRenderer.prepare(scenes.get(first));
        }
        lastExposure = factor;
        try (Progress progress = Progress.start("rendering", frames * size.width() * size.height())) {
            for (int i = 0; i < scenes.size(); i++) {
                if (!missing.get(i) && linear == null) {
                    continue;
                }
                Scene scene = scenes.get(i);
                if (i != first) {
                    frameRenderer.prepare(scene);
                }
                FrameRenderer.Frame frame = frameRenderer.render(scene, factor, progress::step);
                if (missing.get(i)) {
                    places.set(i, write(files.get(i), overwrite, scene, frame));
                }
                if (linear != null) {
                    NpyWriter.write(linear, overwrite, frame.linear().linear().xyz(), size.height(), size.width(), 3);
                }
            }
        }
        return places;
    }

    /** Samples along a pixel's side. */
    int supersample() {
        return supersample;
    }

    /**
     * Compares pixels of the scene that was drawn last.
     *
     * @param exact the same scene by a method that draws points
     */
    SceneCertificate certify(RenderContext context, SceneData exact, int count) {
        try (SceneSession points = new SceneSession(context, exact)) {
            return new SceneCertifier(size.width(), size.height())
                    .certify(sessions.get(0), points, supersample, lastExposure, count, CertifyOption.SEED);
        }
    }

    /**
     * Compares pixels of frames that follow one another.
     *
     * @param exact the first of the scenes by a method that draws points
     * @param scenes of the frames, at least two
     */
    CrawlCertificate certify(RenderContext context, SceneData exact, List<Scene> scenes, int count) {
        List<Scene> points = scenes.stream()
                .map(scene -> scene.withMethod(exact.scene().method()))
                .toList();
        try (SceneSession session = new SceneSession(context, exact)) {
            return new SceneCertifier(size.width(), size.height())
                    .certify(
                            new SceneCertifier.Frames(sessions.get(0), scenes),
                            new SceneCertifier.Frames(session, points),
                            supersample,
                            lastExposure,
                            count,
                            CertifyOption.SEED);
        }
    }

    private static OptionalDouble recordedExposure(Path frame) {
        return Decimals.parse(PngText.read(frame).getOrDefault("Exposure", ""));
    }

    private Path write(Path file, Overwrite overwrite, Scene scene, FrameRenderer.Frame frame) {
        Map<String, String> text =
                FrameText.of(data, scene, size, supersample, frame.exposure(), renderer, identity.of(scene));
        BufferedImage image = frame.image();
        drawn = true;
        light |= !DoubtfulPicture.isBlack(image);
        return PngWriter.write(file, overwrite, image, text);
    }

    /** Whether frames were drawn, and all of them are black. */
    boolean isBlack() {
        return drawn && !light;
    }

    @Override
    public void close() {
        sessions.forEach(SceneSession::close);
    }
}
