package sunbeam.app.commands.render;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Callable;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.app.scene.PixelSamples;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.SettingOptions;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;

/** {@code sunbeam render}: a scene as a picture, or moving, without a window. */
@Command(
        name = "render",
        header = "Draw a scene without a window: picture or animation.",
        description = "Draw a scene: a mesh with a nanostructured skin, its camera and its light. One PNG, or with"
                + " --light-sweep or --turntable a folder of numbered PNGs and an animation of them. Ctrl-C keeps"
                + " the frames that are finished; --resume goes on.")
public final class RenderCommand implements Callable<Integer> {
    private final Environment environment;

    @Parameters(
            paramLabel = "SCENE",
            description =
                    "A built-in scene (elaphe, elaphe-body, elaphe-scales, xenopeltis, xenopeltis-body,"
                            + " xenopeltis-scales, light-left, light-above, light-right) or a scene file (.json; docs/scenes.md).")
    private String sceneName;

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description = "The picture, or of an animation the folder. Default: the scene's name.")
    private Path output;

    @Option(
            names = "--linear",
            paramLabel = "FILE.npy",
            description = "Also write the linear colors: float32, height x width x 3, row 0 on top, CIE XYZ before"
                    + " exposure, NaN where the mesh is not.")
    private Path linear;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            defaultValue = "800x600",
            converter = PictureSize.Converter.class,
            description = "Width and height in pixels. Default: ${DEFAULT-VALUE}.")
    private PictureSize size;

    @Option(
            names = "--supersample",
            paramLabel = "N",
            description =
                    "Each pixel is the mean of N x N, 1 to 8, in linear light. Default: 2 by method table, more in pictures"
                            + " of less than 800 x 600 pixels, of which each sees more; 1 by other methods. --certify"
                            + " says how well a picture is anti-aliased.")
    private Integer supersample;

    @Mixin
    private AnimationOptions animation;

    @Mixin
    private final SettingOptions overrides =
            SettingOptions.overriding(SceneOverrides.SETTINGS, SceneOverrides.STANDARDS);

    @Mixin
    private ForceOption force;

    @Mixin
    private PixelCertificate certificate;

    @Spec
    private CommandSpec specification;

    public RenderCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        check();
        Scene scene = SceneOverrides.apply(Scenes.load(sceneName), overrides.choices());
        List<Scene> scenes = animation.isAsked() ? animation.scenes(scene) : List.of(scene);
        certificate.check(scenes);
        Path target = target();
        List<Path> files = animation.isAsked() ? FrameFiles.names(target, scenes.size()) : List.of(target);
        checkOutputs(files, target);
        PrintWriter err = specification.commandLine().getErr();
        List<SceneData> parts = new SceneLoader(environment, warning -> {
                    err.println(Messages.warning(warning));
                    err.flush();
                })
                .parts(scene);
        SceneData data = parts.get(0);
        PrintWriter out = StandardOutput.reports(specification.commandLine().getOut(), err, output, linear);
        int samples = samples(scene);
        err.println("plan: " + data.method().summary() + "; " + samples * samples
                + (samples == 1 ? " sample a pixel" : " samples a pixel (--supersample " + samples + ")"));
        err.flush();
        try (RenderContext context = RenderContexts.offscreen();
                FrameSequence frames = new FrameSequence(context, parts, size, samples)) {
            Path place = animation.isAsked() ? OutputFolder.claim(target, mayUse()) : target;
            List<Path> wanted = place.equals(target) ? files : FrameFiles.names(place, scenes.size());
            outputs(place, draw(frames, scenes, wanted, place, err))
                    .forEach(file -> out.println(StandardOutput.name(file)));
            ExitCode doubt = DoubtfulPicture.judge(
                    List.of(data.patch()),
                    frames.isBlack(),
                    "the picture",
                    scene.exposure().isEmpty(),
                    err);
            SceneLoader quiet = new SceneLoader(environment, warning -> {});
            ExitCode certified =
                    certificate.print(context, frames, scenes, points -> quiet.load(points, data), out, err);
            return (certified == ExitCode.OK ? doubt : certified).code();
        }
    }

    /** Along the side of a pixel. */
    private int samples(Scene scene) {
        return supersample != null ? supersample : PixelSamples.alongSide(scene.method(), size.width(), size.height());
    }

    private void check() {
        if (supersample != null && (supersample < 1 || supersample > PixelSamples.MOST)) {
            throw new UsageException(
                    "--supersample " + supersample + " is out of range; give 1 to " + PixelSamples.MOST);
        }
        animation.check();
        if (!animation.isAsked()) {
            Ending.PNG.require("--output", output);
        }
        Ending.NPY.require("--linear", linear);
        if (animation.isAsked() && linear != null) {
            throw new UsageException("--linear is for single pictures; leave --light-sweep and --turntable out");
        }
        if (linear != null && linear.equals(output)) {
            throw new UsageException("--linear " + linear + " is the picture's own name; give it another");
        }
        if (animation.isMp4()) {
            Mp4Animation.requireProgram(environment, animation.file(Path.of("")));
        }
    }

    private Path target() {
        if (!animation.isAsked()) {
            return output != null ? output : Path.of(stem() + ".png");
        }
        return FrameFiles.folder(output, stem() + "-" + animation.name(), mayUse());
    }

    /** Whether what has the chosen name is used, in place of the next number. */
    private boolean mayUse() {
        return output != null || animation.resume() || force.overwrite() == Overwrite.REPLACE;
    }

    /** What may become of a picture that has the name of one of these. */
    private Overwrite overwriteOfPictures() {
        return mayUse() || animation.isAsked() ? force.overwrite() : Overwrite.NUMBER;
    }

    /** The scene's name without folder and extension. */
    private String stem() {
        String name = String.valueOf(Path.of(sceneName).getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    /** Before anything is loaded: nobody waits for a picture that cannot be written. */
    private void checkOutputs(List<Path> files, Path target) {
        if (!animation.resume()) {
            FrameFiles.requireFree(files, overwriteOfPictures());
        }
        if (!animation.isAsked() && !animation.resume()) {
            AtomicFile.checkWritable(target, overwriteOfPictures());
        }
        if (animation.isAsked()) {
            OutputFolder.check(target);
            if (Files.isDirectory(target)) {
                AtomicFile.checkWritable(animation.file(target), overwriteOfAnimation());
            }
        }
        if (linear != null) {
            AtomicFile.checkWritable(linear, force.overwrite());
        }
    }

    /** Returns where the pictures are. */
    private List<Path> draw(FrameSequence frames, List<Scene> scenes, List<Path> files, Path target, PrintWriter err) {
        Overwrite overwrite = overwriteOfPictures();
        List<Boolean> missing = animation.resume()
                ? FrameFiles.missing(files, frames.identities(scenes), overwrite)
                : Collections.nCopies(files.size(), true);
        AtomicFile.checkWritable(files.get(0), overwrite == Overwrite.NUMBER ? overwrite : Overwrite.REPLACE);
        Overwrite ofAnimation = overwriteOfAnimation();
        if (animation.isAsked()) {
            AtomicFile.checkWritable(animation.file(target), ofAnimation);
        }
        List<Path> drawn;
        ShutdownHook hook = new ShutdownHook(() -> sayThatFramesAreKept(err));
        try {
            drawn = frames.draw(scenes, files, missing, overwrite, linear);
        } finally {
            hook.close();
        }
        if (animation.isMp4()) {
            Mp4Animation.write(animation.file(target), ofAnimation, files, animation.frameRate());
        } else if (animation.isAsked()) {
            GifAnimation.write(animation.file(target), ofAnimation, files, animation.frameRate());
        }
        if (animation.isAsked()) {
            warnOfOlderFrames(target, files.size(), err);
        }
        return drawn;
    }

    private Overwrite overwriteOfAnimation() {
        return animation.resume() ? Overwrite.REPLACE : force.overwrite();
    }

    private static void warnOfOlderFrames(Path folder, int frames, PrintWriter err) {
        Path next = FrameFiles.names(folder, frames + 1).get(frames);
        if (Files.exists(next)) {
            err.println(
                    Messages.warning(next + " and frames after it are of a longer animation; they were left alone"));
            err.flush();
        }
    }

    private void sayThatFramesAreKept(PrintWriter err) {
        if (animation.isAsked()) {
            err.println(Messages.error("interrupted; finished frames are kept, add --resume to draw the others"));
            err.flush();
        }
    }

    private List<Path> outputs(Path target, List<Path> files) {
        List<Path> outputs = new ArrayList<>();
        if (animation.isAsked()) {
            outputs.add(target);
            outputs.add(animation.file(target));
        } else {
            outputs.addAll(files);
        }
        if (linear != null) {
            outputs.add(linear);
        }
        return outputs;
    }
}
