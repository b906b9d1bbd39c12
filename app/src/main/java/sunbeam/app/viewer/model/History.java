package sunbeam.app.viewer.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import sunbeam.app.scene.Scene;

/** The scenes before the one that is shown, and those that were undone. What a hand does in one go is one step. */
final class History {
    // Further steps are forgotten.
    private static final int LONGEST = 500;
    // Turns of the wheel and keys that follow each other sooner are one step.
    private static final long PAUSE_NANOSECONDS = 400_000_000;

    private final Deque<Scene> before = new ArrayDeque<>();
    private final Deque<Scene> undone = new ArrayDeque<>();
    private boolean isHeld;
    // Whether the next change may belong to the last step, and when that was made.
    private boolean isOpen;
    private long last;

    void hand(boolean holds) {
        isHeld = holds;
        isOpen = false;
    }

    void changed(Scene from, Scene to) {
        if (to.equals(from)) {
            return;
        }
        long now = System.nanoTime();
        if (!isOpen || (!isHeld && now - last > PAUSE_NANOSECONDS)) {
            before.push(from);
            if (before.size() > LONGEST) {
                before.removeLast();
            }
        }
        undone.clear();
        isOpen = true;
        last = now;
    }

    /** As {@link #changed}, in a step of its own however soon after another. */
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
            // A change that could not be loaded has left nothing to undo.
            if (!other.equals(now)) {
                to.push(now);
                return Optional.of(other);
            }
        }
        return Optional.empty();
    }
}
