package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.OperatingSystemMXBean;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.color.Srgb;

/**
 * How long a frame of what moves takes to draw at each resolution, without window and event queue, once all colours are there, and by
 * how much it differs from the picture that stands still: makes a table of docs/viewer.md. Not among the tests: {@code ./sunbeam test -Dtest=MovingFrameRun}, with {@code
 * -Dsunbeam.scene=NAME} and {@code -Dsunbeam.divisors=N}, one of a first to an N-th of columns and rows. Colours are kept in the user's cache.
 */
@NeedsDisplay
class MovingFrameRun {
    private static final int WIDTH = 870;
    private static final int HEIGHT = 811;
    private static final OperatingSystemMXBean PROCESSOR =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private static final int FRAMES = Integer.getInteger("sunbeam.frames", 100);
    private static final int MOST_DIVISOR = Integer.getInteger("sunbeam.divisors", 4);
    private static final long MOST_SECONDS = 300;

    @Test
    void printTimes() throws InterruptedException {
        Scene scene = Scenes.load(System.getProperty("sunbeam.scene", "elaphe"));
        SceneLoader loader = new SceneLoader(Environment.ofProcess(), line -> {});
        LoadedScene loaded = LoadedScene.load(loader, scene, null);
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(context, loaded.fine())) {
            await(session);
            System.out.printf(
                    Locale.ROOT,
                    "%s, %s, ms a frame: 10 %%, median, 95 %% (processor time, mean)%n",
                    scene.mesh(),
                    context.info());
            for (int divisor = 1; divisor <= MOST_DIVISOR; divisor++) {
                System.out.printf(
                        Locale.ROOT,
                        "1:%d  light %s  model %s%n",
                        divisor,
                        times(
                                session,
                                divisor,
                                frame -> scene.withLight(new SceneLight(
                                        new Vector3f((float) Math.sin(0.02 * frame), 0.3f, 1).normalize(),
                                        scene.light().intensity()))),
                        times(
                                session,
                                divisor,
                                frame -> scene.withOrientation(
                                        new Quaternionf(scene.orientation()).rotateLocalY(0.01f * frame))));
            }
            session.update(scene);
            System.out.println(difference(session));
        }
    }

    @FunctionalInterface
    private interface Frames {
        Scene at(int frame);
    }

    private static String times(SceneSession session, int divisor, Frames frames) {
        List<Double> milliseconds = new ArrayList<>();
        List<Double> processor = new ArrayList<>();
        for (int frame = 0; frame < FRAMES; frame++) {
            session.update(frames.at(frame));
            session.takeBaked();
            long processorStart = PROCESSOR.getProcessCpuTime();
            long start = System.nanoTime();
            session.moving(WIDTH, HEIGHT, divisor, 1);
            milliseconds.add((System.nanoTime() - start) * 1e-6);
            processor.add((PROCESSOR.getProcessCpuTime() - processorStart) * 1e-6);
        }
        Collections.sort(milliseconds);
        return String.format(
                Locale.ROOT,
                "%.0f, %.0f, %.0f (processor %.0f)",
                milliseconds.get(FRAMES / 10),
                milliseconds.get(FRAMES / 2),
                milliseconds.get(FRAMES * 95 / 100),
                processor.stream().mapToDouble(Double::doubleValue).average().orElseThrow());
    }

    /** Between the picture that moves, in full resolution, and the one that stands still. */
    private static String difference(SceneSession session) {
        ScenePicture picture = session.draw(WIDTH, HEIGHT);
        Scene scene = session.data().scene();
        double exposure = SceneDisplay.exposure(scene, new PartSum(List.of(session)), WIDTH, HEIGHT);
        List<Double> differences = new ArrayList<>();
        BufferedImage still = SceneDisplay.image(picture, 1, scene.display(exposure), scene.background());
        BufferedImage moving = session.moving(WIDTH, HEIGHT, 1, exposure);
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            if (picture.rgba()[4 * pixel + 3] > 0) {
                int x = pixel % WIDTH;
                int y = pixel / WIDTH;
                differences.add(ColorDifference.ciede2000(lab(still.getRGB(x, y)), lab(moving.getRGB(x, y))));
            }
        }
        Collections.sort(differences);
        return String.format(
                Locale.ROOT,
                "CIEDE2000 between moving and still, %d pixels of skin: mean %.2f, median %.2f, 95 %% %.2f",
                differences.size(),
                differences.stream().mapToDouble(Double::doubleValue).average().orElseThrow(),
                differences.get(differences.size() / 2),
                differences.get(differences.size() * 95 / 100));
    }

    private static CieLab lab(int rgb) {
        double[] xyz = Srgb.xyz(Srgb.linear(rgb >> 16 & 0xff), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff));
        return CieLab.ofXyz(xyz[0], xyz[1], xyz[2]);
    }

    /** Until all is there that pictures look into. */
    private static void await(SceneSession session) throws InterruptedException {
        session.bakeInBackground(true, () -> {});
        long end = System.nanoTime() + MOST_SECONDS * 1_000_000_000L;
        do {
            Thread.sleep(50);
            session.takeBaked();
        } while (!session.canMove() && System.nanoTime() < end);
        session.request(WIDTH, HEIGHT, 1, () -> false);
        while (session.requestedShare() < 1 && System.nanoTime() < end) {
            Thread.sleep(50);
            session.takeBaked();
        }
        assertThat(session.requestedShare()).isEqualTo(1);
    }
}
