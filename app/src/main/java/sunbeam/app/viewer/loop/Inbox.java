package sunbeam.app.viewer.loop;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** Mailbox of the render thread: the newest state (a newer one replaces an older one) and a queue of small tasks. Thread-safe. */
final class Inbox {
    private final Deque<Consumer<Stage>> tasks = new ArrayDeque<>();
    private ViewState newest;
    private boolean closed;

    synchronized void show(ViewState state) {
        newest = state;
        notifyAll();
    }

    synchronized void submit(Consumer<Stage> task) {
        tasks.add(task);
        notifyAll();
    }

    synchronized void close() {
        closed = true;
        notifyAll();
    }

    synchronized boolean isClosed() {
        return closed;
    }

    synchronized boolean isInterrupted() {
        return closed || newest != null;
    }

    synchronized boolean isInterrupted(Predicate<ViewState> by) {
        return closed || (newest != null && by.test(newest));
    }

    /** Removes and returns the next task; empty if there is none or the inbox is closed. Does not wait. */
    synchronized Optional<Consumer<Stage>> task() {
        return closed ? Optional.empty() : Optional.ofNullable(tasks.poll());
    }

    /** Removes and returns the newest state if it is wanted. */
    synchronized Optional<ViewState> state(Predicate<ViewState> wanted) {
        Optional<ViewState> state = Optional.ofNullable(newest).filter(wanted);
        newest = state.isPresent() ? null : newest;
        return state;
    }

    synchronized void await(long nanoseconds) throws InterruptedException {
        long start = System.nanoTime();
        for (long left = nanoseconds; !closed && newest == null && tasks.isEmpty() && left > 0; ) {
            wait(1 + TimeUnit.NANOSECONDS.toMillis(left));
            left = nanoseconds - (System.nanoTime() - start);
        }
    }
}
