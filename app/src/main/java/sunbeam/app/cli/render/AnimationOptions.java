package sunbeam.app.cli.render;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.scene.Motion;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.units.Angles;

/** Options of an animation's motion, a picocli mixin. */
public final class AnimationOptions {
    static final int MOST_FRAMES = 9999;

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
            description = "Frames per second of the animation, 0.1 to 50. Default: 12.")
    private Double frameRate;

    @Option(
            names = "--film",
            paramLabel = "FORMAT",
            description = "Also write animation.FORMAT by the program ffmpeg: ${COMPLETION-CANDIDATES}.")
    private Film film;

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
        UsageException.throwIf(!isGiven() && film != null, "--film needs --light-sweep or --turntable");
        UsageException.throwIf(
                frames != null && lightSweep == null,
                "--frames " + frames + " needs --light-sweep, whose frames it counts"
                        + (turntable != null ? "; --turntable has its own number" : ", as in --light-sweep 0:360"));
        UsageException.requireWithin(turntable != null ? "--turntable" : "--frames", frames(), 1, MOST_FRAMES);
        UsageException.throwIf(
                !(frameRate() >= 0.1 && frameRate() <= 50),
                "--frame-rate " + frameRate + " is out of range; give 0.1 to 50");
    }

    Optional<Film> film() {
        return Optional.ofNullable(film);
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

    /** Writer of an endless animated GIF, dithered by error diffusion (Floyd and Steinberg 1976) so that smooth colors have no bands. */
    static final class GifAnimation {
        private static final String FRAME_FORMAT = "javax_imageio_gif_image_1.0";

        private GifAnimation() {}

        static void write(Path target, Overwrite overwrite, List<Path> frames, double framesPerSecond) {
            int hundredths = (int) Math.max(2, Math.round(100 / framesPerSecond));
            AtomicFile.write(target, overwrite, stream -> write(stream, frames, hundredths));
        }

        private static void write(OutputStream stream, List<Path> frames, int hundredths) throws IOException {
            ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
            try (MemoryCacheImageOutputStream output = new MemoryCacheImageOutputStream(stream)) {
                writer.setOutput(output);
                writer.prepareWriteSequence(null);
                for (int i = 0; i < frames.size(); i++) {
                    BufferedImage image = dithered(ImageFile.ours(frames.get(i), "remove it and use --resume"));
                    IIOMetadata metadata = writer.getDefaultImageMetadata(
                            new ImageTypeSpecifier(image), writer.getDefaultWriteParam());
                    describe(metadata, hundredths, i == 0);
                    writer.writeToSequence(new IIOImage(image, null, metadata), null);
                }
                writer.endWriteSequence();
            } finally {
                writer.dispose();
            }
        }

        private static BufferedImage dithered(BufferedImage image) throws IOException {
            ByteArrayOutputStream undithered = new ByteArrayOutputStream();
            ImageIO.write(image, "gif", undithered);
            IndexColorModel palette = (IndexColorModel) ImageIO.read(new ByteArrayInputStream(undithered.toByteArray()))
                    .getColorModel();
            int width = image.getWidth();
            BufferedImage dithered =
                    new BufferedImage(width, image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED, palette);
            // Errors of this row and the next, three channels a pixel, with a pixel more on either side.
            float[] errors = new float[3 * (width + 2)];
            for (int y = 0; y < image.getHeight(); y++) {
                float[] below = new float[errors.length];
                for (int x = 0; x < width; x++) {
                    int at = 3 * (x + 1);
                    float[] wanted = new float[3];
                    for (int c = 0; c < 3; c++) {
                        int code = image.getRGB(x, y) >> (16 - 8 * c) & 255;
                        wanted[c] = Math.max(0, Math.min(255, code + errors[at + c]));
                    }
                    int nearest = nearest(palette, wanted);
                    dithered.getRaster().setSample(x, y, 0, nearest);
                    for (int c = 0; c < 3; c++) {
                        float error = (wanted[c] - (palette.getRGB(nearest) >> (16 - 8 * c) & 255)) / 16;
                        errors[at + 3 + c] += 7 * error;
                        below[at - 3 + c] += 3 * error;
                        below[at + c] += 5 * error;
                        below[at + 3 + c] += error;
                    }
                }
                errors = below;
            }
            return dithered;
        }

        private static int nearest(IndexColorModel palette, float[] color) {
            int nearest = 0;
            float least = Float.POSITIVE_INFINITY;
            for (int i = 0; i < palette.getMapSize(); i++) {
                float red = color[0] - palette.getRed(i);
                float green = color[1] - palette.getGreen(i);
                float blue = color[2] - palette.getBlue(i);
                float distance = red * red + green * green + blue * blue;
                if (distance < least) {
                    least = distance;
                    nearest = i;
                }
            }
            return nearest;
        }

        private static void describe(IIOMetadata metadata, int hundredths, boolean first) throws IOException {
            IIOMetadataNode root = new IIOMetadataNode(FRAME_FORMAT);
            IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
            root.appendChild(control);
            control.setAttribute("disposalMethod", "doNotDispose");
            control.setAttribute("userInputFlag", "FALSE");
            control.setAttribute("transparentColorFlag", "FALSE");
            control.setAttribute("delayTime", Integer.toString(hundredths));
            control.setAttribute("transparentColorIndex", "0");
            if (first) {
                IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
                loop.setAttribute("applicationID", "NETSCAPE");
                loop.setAttribute("authenticationCode", "2.0");
                // Sub-block 1: number of repetitions, 16 bits; 0 means endless.
                loop.setUserObject(new byte[] {1, 0, 0});
                IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
                extensions.appendChild(loop);
                root.appendChild(extensions);
            }
            metadata.mergeTree(FRAME_FORMAT, root);
        }
    }
}
