package sunbeam.app.cli.render;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import sunbeam.app.cli.CertifyOption;
import sunbeam.app.cli.DisplayOptions.TevOption;
import sunbeam.app.cli.FileCommand;
import sunbeam.app.cli.PictureSize;
import sunbeam.app.cli.SettingOptions;
import sunbeam.app.cli.render.AnimationOptions.GifAnimation;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.TevClient;
import sunbeam.app.render.LightCount;
import sunbeam.app.render.LineDrawings;
import sunbeam.app.render.PixelPicture.LitPixels;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneLoader.LoadingScene;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.text.Text;

/** Command {@code sunbeam render}: draws a scene as a picture or an animation, without a window. */
@Command(
        name = "render",
        header = "Draw a scene without a window: picture or animation.",
        description = "Draw a scene: a mesh with a nanostructured skin, its camera and its light. One PNG, or with"
                + " --light-sweep or --turntable a folder of numbered PNGs and an animation of them. Ctrl-C keeps"
                + " the frames that are finished; --resume goes on.",
        footer = {
            "  sunbeam render elaphe",
            "  sunbeam render my-scene.json --size 1280x720 --output scene.png",
            "  sunbeam render elaphe --patch scan.png --width 65um --max-height 375nm",
            "  sunbeam render xenopeltis --light-sweep 0:360 --frames 12"
        })
public final class RenderCommand extends FileCommand {
    private static final String GIF = "animation.gif";

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = SceneOverrides.Names.class,
            description = "A built-in scene (${COMPLETION-CANDIDATES}) or a scene file (.json; docs/scenes.md).")
    private String sceneName;

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description = "The picture, or the folder of an animation. Default: the scene's name.")
    private Path output;

    @Option(
            names = "--linear",
            paramLabel = "FILE",
            description = "Also write the linear colors before exposure: FILE.npy, float32, height x width x 3, row 0"
                    + " on top, CIE XYZ, NaN where the mesh is not; or FILE.exr, Rec. 709 and alpha.")
    private Path linear;

    @Mixin
    private TevOption tev;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            defaultValue = "800x600",
            description = "Width and height in pixels. Default: ${DEFAULT-VALUE}.")
    private PictureSize size;

    @Option(
            names = "--supersample",
            paramLabel = "N",
            description = "Each pixel is the mean of N x N samples, 1 to 8. Default by method table: 4 samples, or"
                    + " where these differ 4 x 4, then 8 x 8 up to 640 x 360 pixels, more in smaller pictures; 1 by other methods."
                    + " --certify measures the anti-aliasing.")
    private Integer supersample;

    @Mixin
    private AnimationOptions animation;

    @Mixin
    private final SettingOptions overrides =
            SettingOptions.overriding(SceneOverrides.SETTINGS, SceneOverrides.STANDARDS);

    @Option(
            names = "--resume",
            description = "Keep existing pictures that were drawn with the same parameters; draw the others only.")
    private boolean resume;

    @Mixin
    private final FrameSequence.Overlays overlays = new FrameSequence.Overlays();

    @Option(
            names = "--wireframe",
            description = "Draw the edges of the mesh's triangles from the scene's camera, and no light.")
    private boolean wireframe;

    @Mixin
    private CertifyOption certify;

    @Override
    public Integer call() {
        check();
        Scene scene = SceneOverrides.apply(Scenes.load(sceneName), overrides.choices());
        if (wireframe) {
            return drawWireframe(scene);
        }
        List<Scene> scenes = animation.isGiven() ? animation.scenes(scene) : List.of(scene);
        certify.check(scene);
        Path target = output != null ? output : Path.of(FileNames.stem(Path.of(sceneName)) + animation.ending());
        checkFiles(scene, target, scenes.size());
        SceneLoader loader = new SceneLoader(environment(), warning -> err().println(Messages.warning(warning)));
        try (LoadingScene loading = new LoadingScene(loader, scene);
                RenderContext context = loading.offscreen()) {
            return draw(context, loading, scenes, target);
        }
    }

    private int draw(RenderContext context, LoadingScene loading, List<Scene> asked, Path target) {
        PrintWriter err = err();
        PrintWriter out = out(output, linear);
        PixelSamples samples = supersample != null
                ? PixelSamples.uniform(supersample)
                : PixelSamples.of(asked.get(0).method(), size.width(), size.height());
        try (TevClient viewer = tev.connect(err).orElse(null);
                FrameSequence frames = new FrameSequence(
                        context, loading.upload(context), size, samples, overlays, viewer, environment())) {
            List<SceneData> parts = frames.parts();
            Optional<LightCount> count = frames.lightCount(asked.get(0));
            List<Scene> scenes = asked.stream()
                    .map(frame -> count.map(found -> found.in(frame)).orElse(frame))
                    .toList();
            Scene scene = scenes.get(0);
            String lights = count.map(found -> "; " + found.describe()).orElse("");
            SceneData.ofRegions(parts, RenderCommand::plan)
                    .forEach(plan -> err.println(plan + "; " + samples.describe() + lights));
            count.filter(LightCount::isMissed).ifPresent(found -> err.println(Messages.warning(found.complaint())));
            List<Path> written = animation.isGiven() ? animate(frames, scenes, target) : draw(frames, scene, target);
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("scene", sceneName);
            report.put("plans", SceneData.ofRegions(parts, data -> data.method().summary()));
            frames.lit().ifPresent(lit -> report.put("lit_share", lit.share()));
            ExitCode doubt = doubt(frames, parts, err);
            if (!json.isGiven()) {
                json.print(out, report, written);
            }
            ExitCode certified = certify.count()
                    .map(pixels -> frames.certify(scene, pixels, report, json.text(out), err))
                    .orElse(ExitCode.OK);
            if (json.isGiven()) {
                json.print(out, report, written);
            }
            return (certified == ExitCode.OK ? doubt : certified).code();
        }
    }

    private static ExitCode doubt(FrameSequence frames, List<SceneData> parts, PrintWriter err) {
        Optional<LitPixels> lit = frames.lit();
        lit.map(LitPixels::summary).ifPresent(err::println);
        if (lit.isPresent() && lit.get().areTooFew()) {
            err.println(Messages.warning(lit.get().complaint()));
            return ExitCode.TOLERANCE_MISSED;
        }
        return doubt(SceneData.ofRegions(parts, SceneData::patch));
    }

    private static String plan(SceneData data) {
        boolean isOnly = data.scene().patches().isOne()
                && data.scene().looks().stream().distinct().count() == 1;
        String of = isOnly ? "" : " of " + data.patch().name();
        return "plan" + of + ": " + data.method().summary();
    }

    private int drawWireframe(Scene scene) {
        UsageException.throwIf(
                animation.isGiven()
                        || linear != null
                        || resume
                        || overlays.lightCone
                        || certify.count().isPresent(),
                "--wireframe is a picture without light; leave animations, --linear, --resume, --light-cone and --certify out");
        Path file = writable(output, FileNames.stem(Path.of(sceneName)) + "-wireframe.png");
        Mesh mesh = SceneShape.wholeMesh(scene, warning -> err().println(Messages.warning(warning)));
        BufferedImage image = LineDrawings.wireframe(scene, mesh, overlays.strokes, size.width(), size.height());
        Map<String, String> text = new TreeMap<>(Map.of("Title", "Mesh", "Scene", SceneWriter.caption(scene)));
        Path written = PngWriter.write(file, overwrite(output), image, text);
        json.print(out(file), Map.of("scene", sceneName), List.of(written));
        return ExitCode.OK.code();
    }

    private void check() {
        if (supersample != null) {
            UsageException.requireWithin("--supersample", supersample, 1, PixelSamples.MOST);
        }
        animation.check();
        animation.film().ifPresent(Film::requireProgram);
        if (!animation.isGiven()) {
            Ending.PNG.require("--output", output);
        }
        Ending.LINEAR.require("--linear", linear);
        UsageException.throwIf(
                animation.isGiven() && linear != null,
                "--linear is for single pictures; leave --light-sweep and --turntable out");
        UsageException.throwIf(
                linear != null && linear.equals(output),
                "--linear " + linear + " is the picture's own name; give it another");
    }

    /** True if the target may be an existing file or folder; otherwise a taken name gets a number. */
    private boolean mayExist() {
        return output != null || resume || overwrite() == Overwrite.REPLACE;
    }

    private Overwrite unlessResumed() {
        return resume ? Overwrite.REPLACE : overwrite();
    }

    /** Refuses what cannot be written, before anything is drawn. */
    private void checkFiles(Scene scene, Path target, int frames) {
        UsageException.throwIf(
                scene.files().contains(target.toAbsolutePath().normalize().toString()),
                "--output " + target + " is a file of the scene; give another name");
        if (animation.isGiven()) {
            OutputFolder.check(target);
            if (mayExist() && Files.isDirectory(target)) {
                AtomicFile.checkWritable(target.resolve(GIF), unlessResumed());
                animation.film().ifPresent(film -> AtomicFile.checkWritable(film.in(target), unlessResumed()));
            }
        }
        if (mayExist() && overwrite() == Overwrite.REFUSE) {
            Stream<Path> files = animation.isGiven() ? pictures(target) : Stream.of(target);
            files.skip(resume ? frames : 0).filter(Files::exists).findFirst().ifPresent(file -> {
                throw new OutputException.Exists(
                        "cannot " + (resume ? "end before " : "write ") + file + ": it exists; add "
                                + (resume ? "" : "--resume to keep what is finished, or ") + "--force to replace it");
            });
        }
        if (!animation.isGiven()) {
            AtomicFile.checkWritable(target, mayExist() ? unlessResumed() : Overwrite.NUMBER);
        }
        AtomicFile.checkWritable(linear, overwrite());
    }

    /** Returns the names of all frames that an animation may have. */
    private static Stream<Path> pictures(Path folder) {
        return IntStream.rangeClosed(1, AnimationOptions.MOST_FRAMES)
                .mapToObj(frame -> folder.resolve(Text.format("frame-%04d.png", frame)));
    }

    private List<Path> draw(FrameSequence frames, Scene scene, Path target) {
        Overwrite overwrite = mayExist() ? overwrite() : Overwrite.NUMBER;
        List<Path> written = frames.draw(List.of(scene), List.of(target), resume, overwrite, linear);
        return linear == null ? written : List.of(written.get(0), linear);
    }

    private List<Path> animate(FrameSequence frames, List<Scene> scenes, Path target) {
        boolean isNew = !mayExist() || !Files.exists(target);
        Path folder = OutputFolder.claim(target, mayExist());
        List<Path> pictures = pictures(folder).limit(scenes.size()).toList();
        Path gif = folder.resolve(GIF);
        AtomicFile.checkWritable(pictures.get(0), Overwrite.REPLACE);
        String kept = "interrupted; finished frames are kept, add --resume to draw the others";
        ShutdownHook hook = new ShutdownHook(
                () -> err().println(Messages.error(isNew && folder.toFile().delete() ? "interrupted" : kept)));
        try {
            frames.draw(scenes, pictures, resume, overwrite(), null);
        } finally {
            hook.close();
        }
        // A film of the folder would also show the last frames of a longer animation that this one replaces.
        pictures(folder).skip(scenes.size()).forEach(file -> file.toFile().delete());
        GifAnimation.write(gif, unlessResumed(), pictures, animation.frameRate());
        List<Path> written = new ArrayList<>(List.of(folder, gif));
        animation.film().ifPresent(film -> {
            film.write(film.in(folder), unlessResumed(), folder, scenes.size(), animation.frameRate());
            written.add(film.in(folder));
        });
        return written;
    }
}
