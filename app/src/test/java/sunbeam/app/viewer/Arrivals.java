package sunbeam.app.viewer;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Counts the events of mouse and keys that reach the program, so that one can wait for what a robot's hand has done. */
final class Arrivals implements AutoCloseable {
    private static final long MASK =
            AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_WHEEL_EVENT_MASK;

    private final Map<Integer, Integer> counts = new ConcurrentHashMap<>();
    private final AWTEventListener listener = event -> counts.merge(event.getID(), 1, Integer::sum);

    Arrivals() {
        Toolkit.getDefaultToolkit().addAWTEventListener(listener, MASK);
    }

    /**
     * Does something and waits until its events have arrived and been dealt with.
     *
     * @param id of the events to wait for, such as MouseEvent.MOUSE_RELEASED
     * @param number of them
     */
    void await(int id, int number, Runnable gesture) throws Exception {
        int before = count(id);
        gesture.run();
        // Asked on the event thread, that is after the event at hand.
        ViewerInAWindow.await(() -> ViewerInAWindow.onEvents(() -> count(id) >= before + number));
    }

    private int count(int id) {
        return counts.getOrDefault(id, 0);
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
    }
}
