package sunbeam.app.viewer.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import sunbeam.app.scene.Scene;

/** Undo and redo stacks of scenes. A drag is one step. */
final class History {
    // Maximum number of steps, far more than a session needs; bounds memory.
    private static final int LONGEST = 500;
    // Wheel turns and key presses that follow each other within this time are one step.
    private static final long PAUSE_NANOSECONDS = 400_000_000;

    private final Deque<Scene> before = new ArrayDeque<>();
    private final Deque<Scene> undone = new ArrayDeque<>();
    private boolean isDragging;
    // True if the next change may join the last step, and the time of the last change in nanoseconds.
    private boolean isOpen;
    private long last;

    void setDragging(boolean drags) {
        isDragging = drags;
        isOpen = false;
    }

    void changed(Scene from, Scene to) {
        if (to.equals(from)) {
            return;
        }
        long now = System.nanoTime();
        if (!isOpen || (!isDragging && now - last > PAUSE_NANOSECONDS)) {
            before.push(from);
            if (before.size() > LONGEST) {
                before.removeLast();
            }
        }
        undone.clear();
        isOpen = true;
        last = now;
    }

    void opened(Scene from, Scene to) {
        isOpen = false;
        changed(from, to);
        isOpen = false;
    }

    Optional<Scene> undo(Scene now) {
        return move(before, undone, now);
    }

    Optional<Scene> redo(Scene now) {
        return move(undone, before, now);
    }

    private Optional<Scene> move(Deque<Scene> from, Deque<Scene> to, Scene now) {
        isOpen = false;
        while (!from.isEmpty()) {
            Scene other = from.pop();
            // A change that failed to load is not a step.
            if (!other.equals(now)) {
                to.push(now);
                return Optional.of(other);
            }
        }
        return Optional.empty();
    }
}
