package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.MeshSource;
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
final class ViewerRobotTest extends ViewerInAWindow {
    private static final double MINUTES = Double.parseDouble(System.getProperty("sunbeam.robot.minutes", "10"));
    private static final List<String> PATCHES = List.of("elaphe-like", "blaze", "xenopeltis-like");
    private static final List<String> MESHES = List.of("snake", "cylinder", "sphere");

    private final long seed = System.nanoTime();
    private final SplittableRandom random = new SplittableRandom(seed);
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

    @Test
    void nothingWaitsForEver() throws Exception {
        long end = System.nanoTime() + (long) (MINUTES * 60e9);
        while (System.nanoTime() < end) {
            change(scene -> Scenes.load("elaphe"));
            int actions = random.nextInt(5, 60);
            for (int i = 0; i < actions && System.nanoTime() < end; i++) {
                act();
                Thread.sleep(random.nextInt(10) == 0 ? random.nextInt(2000) : random.nextInt(60));
                assertNobodyBlocked();
            }
            if (random.nextBoolean()) {
                onEvents(() -> viewer.window.setSize(700, 500));
                // Other tests cover loads of minutes.
                change(scene -> scene());
                awaitFinal();
            }
            close();
            // The first use of a color source is not interruptible.
            await(() -> Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> List.of("render", "colors").contains(thread.getName())));
            open();
        }
        System.out.println(dump());
        assertNobodyBlocked();
    }

    private void act() throws Exception {
        switch (random.nextInt(8)) {
            case 0, 1 -> dragFar(InputEvent.BUTTON1_DOWN_MASK, MouseEvent.BUTTON1);
            case 2, 3 -> dragFar(InputEvent.BUTTON3_DOWN_MASK, MouseEvent.BUTTON3);
            case 4 -> robot.mouseWheel(random.nextInt(-3, 4));
            case 5 -> {
                for (int i = 0; i < 10; i++) {
                    Scene next = randomScene();
                    change(scene -> next.withView(scene.view()));
                    Thread.sleep(100);
                }
            }
            case 6 -> {
                int width = random.nextInt(1, 1100);
                int height = random.nextInt(1, 900);
                onEvents(() -> viewer.window.setSize(width, height));
            }
            default -> {
                int x = random.nextInt(400);
                onEvents(() -> {
                    viewer.inspector.pick(x, x, false);
                    if (x % 4 == 0) {
                        viewer.presenter.toggle(Overlay.MAP);
                    }
                });
            }
        }
    }

    private Scene randomScene() {
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

    private void dragFar(int held, int button) throws Exception {
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
        onEvents(() -> {
            PictureView view = viewer.window.picture;
            view.dispatchEvent(new MouseEvent(view, kind, System.currentTimeMillis(), held, x, y, 1, false, button));
        });
    }

    private void assertNobodyBlocked() throws InterruptedException {
        for (int look = 0; isBlocked(); look++) {
            assertThat(look).as("seed " + seed + dump()).isLessThan(50);
            Thread.sleep(20);
        }
        assertThat(threads.findDeadlockedThreads()).as("deadlocked").isNull();
    }

    private boolean isBlocked() {
        return Arrays.stream(threads.dumpAllThreads(true, true))
                .anyMatch(thread -> thread.getThreadState() == Thread.State.BLOCKED);
    }

    private String dump() {
        return Arrays.stream(threads.dumpAllThreads(true, true))
                .map(ThreadInfo::toString)
                .collect(Collectors.joining());
    }
}
