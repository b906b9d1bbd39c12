package sunbeam.app.viewer;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Counts mouse and key events that reach the program, so that a test can wait for a robot's gestures. */
final class Arrivals implements AutoCloseable {
    private static final long MASK =
            AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_WHEEL_EVENT_MASK;

    private final Map<Integer, Integer> counts = new ConcurrentHashMap<>();
    private final AWTEventListener listener = event -> counts.merge(event.getID(), 1, Integer::sum);

    Arrivals() {
        Toolkit.getDefaultToolkit().addAWTEventListener(listener, MASK);
    }

    /**
     * Makes a gesture and waits until the program has handled its events.
     *
     * @param id kind of the events, such as MouseEvent.MOUSE_RELEASED
     * @param number of these events
     */
    void await(int id, int number, Runnable gesture) throws Exception {
        int before = count(id);
        gesture.run();
        // Count on the event thread, after the current event.
        ViewerInAWindow.awaitOnEvents(() -> count(id) >= before + number);
    }

    private int count(int id) {
        return counts.getOrDefault(id, 0);
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
    }
}
