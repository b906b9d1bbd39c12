package sunbeam.app.viewer;

import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import sunbeam.app.picture.PictureDifference;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.loop.ViewState;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Measurement of the viewer's latency: posts drags at 60 events a second to the window's event queue and times each until a picture that
 * includes it is painted. Used on the event thread only.
 */
public final class ViewMeasurement {
    private static final int EVENT_MILLISECONDS = 16;
    // Events of a drag forth and back, by a pixel each.
    private static final int PERIOD = 120;
    // The warm-up lasts as long as the measurement or this. It excludes the first frames, which are the coarsest.
    private static final long LONGEST_WARM_UP_NANOSECONDS = 3_000_000_000L;

    private static final long LONGEST_WAIT_NANOSECONDS = 180_000_000_000L;

    private static final List<Drag> DRAGS = List.of(
            new Drag("moving the light", MouseEvent.BUTTON3), new Drag("turning the model", MouseEvent.BUTTON1));

    private record Drag(String title, int button) {}

    /** @param time posting time of the event that changed the scene, since waiting in the queue is latency too; in milliseconds */
    private record Request(ViewState state, long time) {}

    private final Viewer viewer;
    private final Drag drag;
    private final long nanoseconds;
    private final CountDownLatch done = new CountDownLatch(1);
    private final Timer timer = new Timer(EVENT_MILLISECONDS, event -> move());
    // States that are not shown yet, in the order of their requests.
    private final Deque<Request> requests = new ArrayDeque<>();
    private final List<Long> latencies = new ArrayList<>();
    private final List<Double> divisors = new ArrayList<>();
    private long start;
    // Processor time of the process at the end of the warm-up, and its increase until the end of the drag.
    private Optional<Duration> processorBegun = Optional.empty();
    private Duration processor = Duration.ZERO;
    private int steps;
    private boolean isHeld = true;
    private BufferedImage lastFrame;
    private double lastDivisor = 1;
    private Optional<PictureDifference> finalDifference = Optional.empty();

    private ViewMeasurement(Viewer viewer, Drag drag, double seconds) {
        this.viewer = viewer;
        this.drag = drag;
        this.nanoseconds = (long) (seconds * 1e9);
    }

    /** Drags the light and then the model, some seconds each after the warm-up; returns a line for each. Not on the event thread. */
    public static String of(Viewer viewer, double seconds) throws InterruptedException {
        List<String> lines = new ArrayList<>();
        for (Drag drag : DRAGS) {
            ViewMeasurement measurement = new ViewMeasurement(viewer, drag, seconds);
            SwingUtilities.invokeLater(measurement::begin);
            measurement.done.await();
            lines.add(drag.title + ": " + measurement.report());
        }
        return String.join(System.lineSeparator(), lines);
    }

    private void begin() {
        viewer.presenter.measurement = Optional.of(this);
        start = System.nanoTime() + Math.min(nanoseconds, LONGEST_WARM_UP_NANOSECONDS);
        send(MouseEvent.MOUSE_PRESSED, 0);
        timer.start();
    }

    /** Drags back and forth, so that the light stays above the scene and the model in view; then waits for the final picture. */
    private void move() {
        long since = System.nanoTime() - start - nanoseconds;
        if (since > 0) {
            if (isHeld) {
                isHeld = false;
                processor = processorTime().minus(processorBegun.orElseGet(ViewMeasurement::processorTime));
                keepFrame();
                send(MouseEvent.MOUSE_RELEASED, 0);
            } else if (viewer.presenter.finished().isPresent()) {
                finalDifference = Optional.of(PictureDifference.of(
                        lastFrame, viewer.window.picture.picture().orElseThrow()));
                finish();
            } else if (since > LONGEST_WAIT_NANOSECONDS) {
                finish();
            }
            return;
        }
        if (since > -nanoseconds && processorBegun.isEmpty()) {
            processorBegun = Optional.of(processorTime());
        }
        int phase = ++steps % PERIOD;
        send(MouseEvent.MOUSE_DRAGGED, Math.min(phase, PERIOD - phase));
    }

    private void finish() {
        timer.stop();
        viewer.presenter.measurement = Optional.empty();
        done.countDown();
    }

    private static Duration processorTime() {
        return ProcessHandle.current().info().totalCpuDuration().orElse(Duration.ZERO);
    }

    private void keepFrame() {
        BufferedImage shown = viewer.window.picture.picture().orElseThrow();
        lastFrame = new BufferedImage(shown.getWidth(), shown.getHeight(), BufferedImage.TYPE_INT_RGB);
        lastFrame.setData(shown.getData());
    }

    private void send(int kind, int offset) {
        PictureView view = viewer.window.picture;
        int held = MouseEvent.getMaskForButton(drag.button);
        int x = view.getWidth() / 2 + offset;
        int y = view.getHeight() / 2;
        MouseEvent event = new MouseEvent(view, kind, System.currentTimeMillis(), held, x, y, 1, false, drag.button);
        Toolkit.getDefaultToolkit().getSystemEventQueue().postEvent(event);
    }

    void requested(ViewState state) {
        requests.add(new Request(state, EventQueue.getMostRecentEventTime()));
    }

    void shown(ViewState state, double divisor) {
        Toolkit.getDefaultToolkit().sync();
        if (requests.stream().noneMatch(request -> SceneSharing.isSame(request.state, state))) {
            return;
        }
        if (!isHeld) {
            keepFrame();
        }
        lastDivisor = divisor;
        List<Long> times = new ArrayList<>();
        Request request;
        do {
            request = requests.remove();
            times.add(System.currentTimeMillis() - request.time);
        } while (!SceneSharing.isSame(request.state, state));
        if (System.nanoTime() > start) {
            latencies.addAll(times);
            divisors.add(divisor);
        }
    }

    private String report() {
        if (latencies.isEmpty()) {
            return Text.format("no frame was shown in %.0f s", nanoseconds * 1e-9);
        }
        return Text.format(
                "%d x %d pixels, 1:%s of columns and rows (median), %.1f frames per second, %.0f ms of processor time each, from input to"
                        + " screen %d ms (median), %d ms (95 %%), %d ms (longest); from the last frame (1:%s) to the final picture %s",
                viewer.window.picture.pictureWidth(),
                viewer.window.picture.pictureHeight(),
                Decimals.format(quantile(divisors, 0.5)),
                divisors.size() / (nanoseconds * 1e-9),
                processor.toNanos() * 1e-6 / divisors.size(),
                quantile(latencies, 0.5),
                quantile(latencies, 0.95),
                quantile(latencies, 1),
                Decimals.format(lastDivisor),
                finalDifference.map(PictureDifference::text).orElse("more than three minutes"));
    }

    private static <T extends Comparable<T>> T quantile(List<T> values, double share) {
        return values.stream().sorted().toList().get((int) Math.min(values.size() - 1.0, share * values.size()));
    }

    /** Times at which the viewer's start first reached its stages, and the processor time until then. Thread-safe. */
    public static final class StartJournal {
        private final Map<String, String> moments = new LinkedHashMap<>();

        public synchronized void reached(String stage) {
            moments.computeIfAbsent(stage, first -> {
                ProcessHandle.Info process = ProcessHandle.current().info();
                Instant now = Instant.now();
                Duration elapsed = Duration.between(process.startInstant().orElse(now), now);
                Duration processor = process.totalCpuDuration().orElse(Duration.ZERO);
                return Text.format("%s %.1f s (%.1f)", stage, elapsed.toMillis() * 1e-3, processor.toMillis() * 1e-3);
            });
        }

        public synchronized String report() {
            return "since the process began (processor time in brackets): " + String.join(", ", moments.values());
        }
    }
}
