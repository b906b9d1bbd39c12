package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import jrtr.Tile;
import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.terminal.Environment;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.setting.Choices;

/** Test that draws scenes in one render context, with a new folder as home. */
public abstract class InAScene extends InAContext {
    @TempDir
    protected Path folder;

    protected final List<String> warnings = new ArrayList<>();

    protected static final Choices DIFFRACTION_ONLY = Weights.of(1, 0, 0, 0);

    /** The blazed grating, viewed near its normal; the light sends orders to the camera. */
    protected static Scene blaze() {
        Choices own = Choices.none()
                .with(SceneSettings.TITLE, "plane")
                .with(SceneSettings.MESH, "plane")
                .with(SceneSettings.TEXTURE, "none")
                .with(SceneSettings.EXPOSURE, OptionalDouble.of(1))
                .with(SceneSettings.BACKGROUND, Optional.of(new SceneColor(0x204060)))
                .over(DIFFRACTION_ONLY);
        return new Scene(
                own,
                PatchAtlas.of(PatchRequest.of("blaze")),
                new Viewpoint(
                        new Camera(new Vector3f(-0.05f, -0.1f, 0.4f), new Vector3f(), new Vector3f(0, 1, 0)),
                        Math.toRadians(40)),
                new Quaternionf(),
                new SceneLight(new Vector3f(-0.2f, 0.3f, 0.9f), 1, 0),
                List.of(),
                new SceneMethod(Choices.none().with(Methods.METHOD, FullMethod.TYPE)));
    }

    protected static Choices around(Optional<SceneColor> ground, double sky, boolean shadows) {
        return Choices.none()
                .with(SceneSettings.GROUND, ground)
                .with(SceneSettings.SKY, sky)
                .with(SceneSettings.SHADOWS, shadows);
    }

    protected final List<SceneData> parts(Scene scene) {
        return parts(scene, loader());
    }

    /** Loads a scene with a folder as home, where tables are cached. */
    public static List<SceneData> parts(Scene scene, Path home) {
        return parts(scene, new SceneLoader(new Environment(Map.of(), home), line -> {}));
    }

    private static List<SceneData> parts(Scene scene, SceneLoader loader) {
        return loader.parts(scene, BackgroundTask.start(() -> loader.shape(scene)));
    }

    protected final SceneLoader loader() {
        return new SceneLoader(new Environment(Map.of(), folder), warnings::add);
    }

    protected final SceneData load(Scene scene) {
        return parts(scene).get(0);
    }

    protected final SceneSession session(Scene scene) {
        return new SceneSession(context, load(scene));
    }

    /** Writes a picture of these pixels, row by row from the top, and returns its file. */
    protected final String image(int type, int width, int... argb) throws IOException {
        BufferedImage image = new BufferedImage(width, argb.length / width, type);
        image.setRGB(0, 0, width, argb.length / width, argb, 0, width);
        Path file = Files.createTempFile(folder, "image", ".png");
        ImageIO.write(image, "png", file.toFile());
        return file.toString();
    }

    /** Returns linear RGBA of a whole picture. */
    protected final float[] drawn(Scene scene, int width, int height) {
        try (SceneSession session = session(scene)) {
            return picture(session, width, height).rgba();
        }
    }

    protected static ScenePicture picture(SceneSession session, int width, int height) {
        ScenePicture picture = ScenePicture.empty(width, height);
        for (DrawRequest part : SceneSession.parts(session.scene(), width, height, PixelSamples.uniform(1))) {
            picture.put(session.draw(part), part.tile().x(), part.tile().y());
        }
        return picture;
    }

    /** Returns a moving picture's 0xffRRGGBB. */
    protected static int[] moving(SceneSession session, int width, int height) {
        return session.moving(width, height, 1, 1).getRGB(0, 0, width, height, null, 0, width);
    }

    /** Asserts that channels of 8 bits differ by at most some steps. */
    protected static void assertAlike(int[] rgb, int[] expected, int steps) {
        for (int i = 0; i < rgb.length; i++) {
            for (int shift = 0; shift < 24; shift += 8) {
                assertThat(rgb[i] >> shift & 0xff).isCloseTo(expected[i] >> shift & 0xff, within(steps));
            }
        }
    }

    /** Compares pixels of diffracted light, chosen by their rank in brightness, with the exact XYZ of their directions. */
    protected static void assertExact(
            SceneSession session, ScenePicture drawn, Function<DirectionPair, double[]> exact, int... ranks) {
        int[] byLuminance = byLuminance(drawn.rgba());
        double brightest = 0;
        for (int rank : ranks) {
            int pixel = byLuminance[rank];
            Pick pick = session.pick(pixel % drawn.width(), pixel / drawn.width(), drawn.width(), drawn.height())
                    .orElseThrow();
            double[] xyz = exact.apply(new DirectionPair(pick.wi(), pick.wr()));
            double scale = DoubleStream.of(xyz).max().orElseThrow();
            brightest = Math.max(brightest, scale);
            for (int c = 0; c < 3; c++) {
                // The plan's tolerance is 1e-3 for each of five sources; directions in float32 add 1e-4 where an
                // order's flank is steep. Channels are compared in proportion to the brightest.
                assertThat((double) drawn.rgba()[4 * pixel + c])
                        .as("channel %d of pixel %d", c, pixel)
                        .isCloseTo(xyz[c], within(5e-3 * scale + 1e-7));
            }
        }
        assertThat(brightest).as("the test looks at lit orders").isGreaterThan(1e-4);
    }

    protected static ScenePicture sum(List<SceneData> parts, int width, int height) {
        List<SceneSession> sessions = new ArrayList<>();
        try {
            parts.forEach(part -> sessions.add(new SceneSession(context, part)));
            Scene scene = parts.get(0).scene();
            PartSum sum = new PartSum(sessions);
            return sum.draw(DrawRequest.ofPixels(scene, width, height, Tile.whole(width, height), 1));
        } finally {
            sessions.forEach(SceneSession::close);
        }
    }

    /** Returns the indices of pixels, the brightest first. */
    protected static int[] byLuminance(float[] rgba) {
        return IntStream.range(0, rgba.length / 4)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> -rgba[4 * i + 1]))
                .mapToInt(Integer::intValue)
                .toArray();
    }
}
