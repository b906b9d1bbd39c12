package sunbeam.app.cli.render;

import java.util.List;
import java.util.stream.IntStream;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;
import sunbeam.app.scene.Motion;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.units.Angles;

/** Options of an animation's motion, a picocli mixin. */
public final class AnimationOptions {
    private static final int MOST_FRAMES = 9999;

    @Option(
            names = "--light-sweep",
            paramLabel = "FROM:TO",
            description = "Frames with the light turned about the vertical by angles FROM to TO in degrees,"
                    + " counter-clockwise seen from above, 0 being where the scene has it. A whole turn leaves its last"
                    + " angle out.")
    private Sweep lightSweep;

    @Option(
            names = "--turntable",
            paramLabel = "N",
            description = "N frames of the mesh turning once about the vertical; light and camera stay.")
    private Integer turntable;

    @Option(names = "--frames", paramLabel = "N", description = "Number of frames of --light-sweep. Default: 24.")
    private Integer frames;

    @Option(
            names = "--frame-rate",
            paramLabel = "HERTZ",
            description = "Frames per second of animation.gif, 0.1 to 50. Default: 12.")
    private Double frameRate;

    /** Equally spaced angles, radians. */
    public record Sweep(double from, double to) {
        /** Parses {@code FROM:TO}, in degrees unless they name a unit. */
        public static Sweep parse(String text) {
            String[] parts = text.split(":", -1);
            if (parts.length != 2) {
                throw new TypeConversionException(
                        "'" + text + "' is not a sweep; give FROM:TO in degrees as in -60:60");
            }
            try {
                return new Sweep(Angles.parse(parts[0]), Angles.parse(parts[1]));
            } catch (IllegalArgumentException failure) {
                throw new TypeConversionException(failure.getMessage());
            }
        }

        /** Returns the angle of a frame, counted from 0. Whole turns leave out the last angle, the same as the first, to loop smoothly. */
        double at(int frame, int frames) {
            double turns = (to - from) / (2 * Math.PI);
            boolean whole = Math.abs(turns) > 0.5 && Math.abs(turns - Math.rint(turns)) < 1e-9;
            int steps = whole ? frames : frames - 1;
            return steps == 0 ? from : from + (to - from) * frame / steps;
        }
    }

    boolean isGiven() {
        return lightSweep != null || turntable != null;
    }

    double frameRate() {
        return frameRate != null ? frameRate : 12;
    }

    /** Returns the end of the output's name: a folder's for an animation, a picture's otherwise. */
    String ending() {
        return lightSweep != null ? "-light-sweep" : turntable != null ? "-turntable" : ".png";
    }

    void check() {
        UsageException.throwIf(
                lightSweep != null && turntable != null,
                "--light-sweep and --turntable contradict each other; leave one out");
        UsageException.throwIf(!isGiven() && frameRate != null, "--frame-rate needs --light-sweep or --turntable");
        UsageException.throwIf(
                frames != null && lightSweep == null,
                "--frames " + frames + " needs --light-sweep, whose frames it counts"
                        + (turntable != null ? "; --turntable has its own number" : ", as in --light-sweep 0:360"));
        UsageException.requireWithin(turntable != null ? "--turntable" : "--frames", frames(), 1, MOST_FRAMES);
        UsageException.throwIf(
                !(frameRate() >= 0.1 && frameRate() <= 50),
                "--frame-rate " + frameRate + " is out of range; give 0.1 to 50");
    }

    private int frames() {
        return turntable != null ? turntable : frames != null ? frames : 24;
    }

    List<Scene> scenes(Scene scene) {
        Motion motion = lightSweep != null ? Motion.LIGHT_SWEEP : Motion.TURNTABLE;
        Sweep sweep = lightSweep != null ? lightSweep : new Sweep(0, 2 * Math.PI);
        return IntStream.range(0, frames())
                .mapToObj(frame -> motion.at(scene, sweep.at(frame, frames())))
                .toList();
    }
}
