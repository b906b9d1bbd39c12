package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.terminal.Environment;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.app.viewer.window.Viewer;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** A robot uses the viewer for {@code -Dsunbeam.robot.minutes} (10) without pause: no thread blocks, and each picture becomes final. */
@Tag("thorough")
@Timeout(value = 2, unit = TimeUnit.HOURS)
final class ViewerRobotTest {
    private static final double MINUTES = Double.parseDouble(System.getProperty("sunbeam.robot.minutes", "10"));
    private static final long PATIENCE_MILLISECONDS = 180_000;
    private static final List<String> PATCHES = List.of("elaphe-like", "blaze", "xenopeltis-like");
    private static final List<String> MESHES = List.of("snake", "cylinder", "sphere");

    @TempDir
    private Path folder;

    private final long seed = System.nanoTime();
    private final SplittableRandom random = new SplittableRandom(seed);
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private Viewer viewer;

    @Test
    void nothingWaitsForEver() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no DISPLAY: windows cannot be tested");
        long end = System.nanoTime() + (long) (MINUTES * 60e9);
        while (System.nanoTime() < end) {
            viewer = ViewerStart.open(
                    Scenes.load("elaphe"),
                    new Environment(Map.of("XDG_CACHE_HOME", "" + folder), folder),
                    line -> {},
                    null);
            int actions = random.nextInt(5, 60);
            for (int i = 0; i < actions && System.nanoTime() < end; i++) {
                act();
                Thread.sleep(random.nextInt(10) == 0 ? random.nextInt(2000) : random.nextInt(60));
                assertNobodyBlocked();
            }
            if (random.nextBoolean()) {
                awaitFinal();
            }
            on(viewer::quit);
            viewer.awaitEnd(PATIENCE_MILLISECONDS);
            assertThat(viewer.hasEnded()).as("ended, seed " + seed).isTrue();
            // The first use of a color source is not interruptible.
            ViewerInAWindow.await(() -> Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> List.of("render", "colors").contains(thread.getName())));
        }
        System.out.println(dump());
        assertNobodyBlocked();
    }

    private void act() throws Exception {
        switch (random.nextInt(8)) {
            case 0, 1 -> drag(InputEvent.BUTTON1_DOWN_MASK, MouseEvent.BUTTON1);
            case 2, 3 -> drag(InputEvent.BUTTON3_DOWN_MASK, MouseEvent.BUTTON3);
            case 4 -> wheel();
            case 5 -> {
                for (int i = 0; i < 10; i++) {
                    Scene next = scene();
                    on(() -> viewer.model().change(scene -> next.withView(scene.view())));
                    Thread.sleep(100);
                }
            }
            case 6 -> {
                int width = random.nextInt(1, 1100);
                int height = random.nextInt(1, 900);
                on(() -> viewer.window().setSize(width, height));
            }
            default -> {
                int x = random.nextInt(400);
                on(() -> {
                    viewer.presenter().pick(x, x);
                    if (x % 4 == 0) {
                        viewer.presenter().toggleMap();
                    }
                });
            }
        }
    }

    private Scene scene() {
        Choices method = Choices.none()
                .with(Methods.METHOD, random.nextInt(3) == 0 ? FullMethod.TYPE : TableMethod.TYPE)
                .with(MethodSettings.TOLERANCE, random.nextBoolean() ? 0.05 : 0.01)
                .with(MethodSettings.AVERAGE, random.nextInt(4) == 0 ? Average.COHERENT : Average.ENSEMBLE)
                .with(MethodSettings.COHERENCE_LENGTH, random.nextBoolean() ? 65e-6 : 15e-6);
        return Scenes.load("elaphe")
                .withMesh(MeshSource.of(MESHES.get(random.nextInt(MESHES.size()))))
                .withPatch(PatchRequest.of(PATCHES.get(random.nextInt(PATCHES.size()))))
                .with(method);
    }

    private void drag(int held, int button) throws Exception {
        post(MouseEvent.MOUSE_PRESSED, held, 200, 200, button);
        int steps = random.nextInt(1, 60);
        int right = random.nextInt(-4, 5);
        for (int i = 0; i < steps; i++) {
            post(MouseEvent.MOUSE_DRAGGED, held, 200 + i * right, 200 + i, button);
            Thread.sleep(16);
        }
        post(MouseEvent.MOUSE_RELEASED, held, 200, 200, button);
    }

    private void post(int kind, int held, int x, int y, int button) throws Exception {
        on(() -> {
            PictureView view = viewer.window().picture();
            view.dispatchEvent(new MouseEvent(view, kind, System.currentTimeMillis(), held, x, y, 1, false, button));
        });
    }

    private void wheel() throws Exception {
        int notches = random.nextInt(-3, 4);
        on(() -> {
            PictureView view = viewer.window().picture();
            view.dispatchEvent(new MouseWheelEvent(
                    view, MouseEvent.MOUSE_WHEEL, System.currentTimeMillis(), 0, 9, 9, 1, false, 0, 3, notches));
        });
    }

    private static void on(Runnable action) throws Exception {
        ViewerInAWindow.onEvents(() -> {
            action.run();
            return null;
        });
    }

    private void awaitFinal() throws Exception {
        on(() -> {
            viewer.window().setSize(700, 500);
            // Other tests cover loads of minutes.
            viewer.model().change(scene -> ViewerInAWindow.scene());
        });
        long end = System.currentTimeMillis() + PATIENCE_MILLISECONDS;
        while (!ViewerInAWindow.onEvents(
                () -> viewer.window().picture().isFinal() && viewer.presenter().isSettled())) {
            assertThat(System.currentTimeMillis()).as("seed " + seed + dump()).isLessThan(end);
            Thread.sleep(100);
        }
    }

    /** Asserts that no thread waits long for a lock. */
    private void assertNobodyBlocked() throws InterruptedException {
        for (int look = 0; !blocked().isEmpty(); look++) {
            assertThat(look).as("seed " + seed + dump()).isLessThan(50);
            Thread.sleep(20);
        }
        assertThat(threads.findDeadlockedThreads()).as("deadlocked").isNull();
    }

    private List<ThreadInfo> blocked() {
        return Arrays.stream(threads.dumpAllThreads(true, true))
                .filter(thread -> thread.getThreadState() == Thread.State.BLOCKED)
                .toList();
    }

    private String dump() {
        return Arrays.stream(threads.dumpAllThreads(true, true))
                .map(ThreadInfo::toString)
                .collect(Collectors.joining());
    }
}
