package sunbeam.app.commands.render;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Option;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.UsageException;

/** What moves; to be used as a picocli mixin. */
public final class AnimationOptions {
    private static final int FRAMES = 24;
    private static final double FRAME_RATE = 12;
    private static final int MOST_FRAMES = 9999;

    @Option(
            names = "--light-sweep",
            paramLabel = "FROM:TO",
            converter = AngleSweep.Converter.class,
            description = "Frames with the light turned about the vertical by angles FROM to TO in degrees,"
                    + " counter-clockwise seen from above, 0 being where the scene has it. A whole turn leaves its last"
                    + " angle out.")
    private AngleSweep lightSweep;

    @Option(
            names = "--turntable",
            paramLabel = "N",
            description = "N frames of the mesh turning about the vertical; light and camera stay.")
    private Integer turntable;

    @Option(
            names = "--turn",
            paramLabel = "FROM:TO",
            converter = AngleSweep.Converter.class,
            description = "Between which angles --turntable turns the mesh, from where the scene has it. Default: once"
                    + " round.")
    private AngleSweep turn;

    @Option(names = "--frames", paramLabel = "N", description = "Number of frames of --light-sweep. Default: 24.")
    private Integer frames;

    @Option(
            names = "--frame-rate",
            paramLabel = "HERTZ",
            description = "Frames per second of the animation, 0.1 to 50. Default: 12.")
    private Double frameRate;

    @Option(
            names = "--animation",
            paramLabel = "FILE",
            description = "The animation: .gif, or .mp4 where ffmpeg is installed. Default: animation.gif in the"
                    + " folder of the frames.")
    private Path animation;

    @Option(
            names = "--resume",
            description = "Keep pictures that are there and were drawn with the same parameters; draw the others only.")
    private boolean resume;

    boolean isAsked() {
        return lightSweep != null || turntable != null;
    }

    boolean resume() {
        return resume;
    }

    double frameRate() {
        return frameRate != null ? frameRate : FRAME_RATE;
    }

    /** For a folder's name. */
    String name() {
        return lightSweep != null ? "light-sweep" : "turntable";
    }

    /** The animation's file. */
    Path file(Path folder) {
        return animation != null ? animation : folder.resolve("animation.gif");
    }

    boolean isMp4() {
        return animation != null && extension().equals("mp4");
    }

    private String extension() {
        String name = String.valueOf(animation.getFileName()).toLowerCase(Locale.ROOT);
        return name.substring(name.lastIndexOf('.') + 1);
    }

    void check() {
        if (lightSweep != null && turntable != null) {
            throw new UsageException("--light-sweep and --turntable contradict each other; leave one out");
        }
        if (turn != null && turntable == null) {
            throw new UsageException("--turn needs --turntable, whose frames it turns");
        }
        if (!isAsked() && (animation != null || frameRate != null)) {
            throw new UsageException(
                    (animation != null ? "--animation" : "--frame-rate") + " needs --light-sweep or --turntable");
        }
        if (frames != null && lightSweep == null) {
            throw new UsageException("--frames " + frames + " needs --light-sweep, whose frames it counts"
                    + (turntable != null ? "; --turntable has its own number" : ", as in --light-sweep 0:360"));
        }
        int count = turntable != null ? turntable : frames();
        if (count < 1 || count > MOST_FRAMES) {
            throw new UsageException((turntable != null ? "--turntable " : "--frames ") + count
                    + " is out of range; give 1 to " + MOST_FRAMES);
        }
        if (!(frameRate() >= 0.1 && frameRate() <= 50)) {
            throw new UsageException("--frame-rate " + frameRate + " is out of range; give 0.1 to 50");
        }
        if (animation != null && !List.of("gif", "mp4").contains(extension())) {
            throw new UsageException("--animation " + animation + " is neither .gif nor .mp4");
        }
    }

    /** The scenes of the frames. */
    List<Scene> scenes(Scene scene) {
        return turntable != null
                ? Motion.turntable(scene, turn != null ? turn : Motion.ONCE_ROUND, turntable)
                : Motion.lightSweep(scene, lightSweep, frames());
    }

    private int frames() {
        return frames != null ? frames : FRAMES;
    }
}
