package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.gl.RenderContexts;
import jrtr.scene.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** What moves is drawn from other geometry (shaders/moving_geometry.frag) and fewer looks than what stands still, and shows the same. */
@NeedsDisplay
class MovingPictureTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final long MOST_SECONDS = 60;

    @TempDir
    private Path folder;

    /** Of the channels of two pictures, 0 to 255. */
    private record Difference(int largest, double mean) {
        static Difference of(BufferedImage one, BufferedImage other) {
            int largest = 0;
            long sum = 0;
            for (int y = 0; y < one.getHeight(); y++) {
                for (int x = 0; x < one.getWidth(); x++) {
                    for (int shift = 0; shift < 24; shift += 8) {
                        int difference =
                                Math.abs((one.getRGB(x, y) >> shift & 0xff) - (other.getRGB(x, y) >> shift & 0xff));
                        largest = Math.max(largest, difference);
                        sum += difference;
                    }
                }
            }
            return new Difference(largest, sum / (3.0 * one.getWidth() * one.getHeight()));
        }
    }

    private static void awaitColors(SceneSession session) throws InterruptedException {
        session.bakeInBackground(true, () -> {});
        long end = System.nanoTime() + MOST_SECONDS * 1_000_000_000L;
        session.requestMoving(WIDTH, HEIGHT, () -> false);
        while (session.requestedShare() < 1 && System.nanoTime() < end) {
            Thread.sleep(10);
            session.takeBaked();
        }
        assertThat(session.requestedShare()).isEqualTo(1);
    }

    private BufferedImage moving(Scene scene) throws InterruptedException {
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(
                        context, PlaneScenes.load(scene.withMethod(method(TableMethod.TYPE)), folder))) {
            if (scene.blend().diffraction() > 0) {
                awaitColors(session);
            }
            return session.moving(WIDTH, HEIGHT, 1, scene.exposure().orElseThrow());
        }
    }

    private BufferedImage still(Scene scene) {
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(
                        context, PlaneScenes.load(scene.withMethod(method(FullMethod.TYPE)), folder))) {
            return SceneDisplay.image(
                    session.draw(WIDTH, HEIGHT),
                    1,
                    scene.display(scene.exposure().orElseThrow()),
                    scene.background());
        }
    }

    private static SceneMethod method(MethodType type) {
        return new SceneMethod(Choices.none().with(Methods.METHOD, type).with(MethodSettings.TOLERANCE, 1e-2));
    }

    private Difference difference(Scene scene) throws InterruptedException {
        BufferedImage still = still(scene);
        assertThat(lightPixels(still)).as("pixels that are not dark").isGreaterThan(150);
        return Difference.of(moving(scene), still);
    }

    private static long lightPixels(BufferedImage image) {
        int[] pixels = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        return Arrays.stream(pixels)
                .filter(rgb -> Math.max(rgb >> 16 & 0xff, Math.max(rgb >> 8 & 0xff, rgb & 0xff)) > 60)
                .count();
    }

    @Test
    void aTexturedBodyIsTheSameToAStep() throws InterruptedException {
        Scene ball = PlaneScenes.blaze()
                .withMesh("sphere")
                .withTexture("elaphe")
                .withBlend(new Blend(0, 1, 0.8, 0.2))
                .withView(view(new Vector3f(0.05f, -0.1f, 0.4f), 40));
        // The texture is rounded to steps of a screen, too.
        assertThat(difference(ball).largest()).isLessThanOrEqualTo(1);
    }

    @Test
    void diffractedLightIsTheSameFromEverySideOfATurnedPatch() throws InterruptedException {
        Scene plane = PlaneScenes.blaze().withBlend(new Blend(100, 0, 0, 0));
        Scene turned = plane.withLight(new SceneLight(new Vector3f(-0.2f, 0.242f, 0.949f), 1))
                .withView(view(new Vector3f(-0.05f, -0.1f, 0.4f), 6))
                .withRotatePatch(0.03)
                .withOrientation(new Quaternionf().rotationXYZ(0.01f, -0.01f, 0.02f));
        // The grating is mirrored, too: all that matters is on the other side.
        Scene mirrored = plane.withMesh(mirrored())
                .withLight(new SceneLight(new Vector3f(0.2f, 0.242f, 0.949f), 1))
                .withView(view(new Vector3f(0.05f, -0.1f, 0.4f), 6))
                .withRotatePatch(0.03);
        for (Scene scene : List.of(turned, mirrored)) {
            // Linear between coefficients and slices where the other is cubic: less than a step in the mean.
            assertThat(difference(scene).mean()).isLessThan(1);
        }
    }

    private static Viewpoint view(Vector3f eye, double fieldOfViewDegrees) {
        return new Viewpoint(
                new Camera(eye, new Vector3f(), new Vector3f(0, 0.8f, 0.6f)), Math.toRadians(fieldOfViewDegrees));
    }

    /** A square whose texture runs from right to left, so that its tangent frame is left-handed. */
    private String mirrored() {
        Path mesh = folder.resolve("mirrored.obj");
        try {
            Files.writeString(mesh, """
                    v -0.1 -0.1 0
                    v 0.1 -0.1 0
                    v 0.1 0.1 0
                    v -0.1 0.1 0
                    vt 1 0
                    vt 0 0
                    vt 0 1
                    vt 1 1
                    f 1/1 2/2 3/3 4/4
                    """);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return mesh.toString();
    }

    /** Graphics cards look in several places, software in one: both must compile, whatever the machine of the test has. */
    @ParameterizedTest
    @ValueSource(strings = {"1", "4"})
    void compilesForAnyNumberOfPlaces(String places) {
        SceneData data = PlaneScenes.load(PlaneScenes.blaze().withMethod(method(TableMethod.TYPE)), folder);
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables tables = UploadedTables.upload(context, data.tables());
                ShaderProgram program = tables.program("moving.frag", Map.of("PLACES", places))) {
            program.set("mostPlaces", Float.parseFloat(places));
        }
    }
}
