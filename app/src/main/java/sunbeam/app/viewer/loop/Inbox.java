package sunbeam.app.viewer.loop;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/**
 * What the render thread has to do: the newest state to show, older ones being forgotten, and small tasks, none of which
 * is. Thread-safe.
 *
 * @param <S> states
 * @param <T> tasks
 */
final class Inbox<S, T> {
    private final Deque<T> tasks = new ArrayDeque<>();
    private S newest;
    private boolean closed;

    synchronized void show(S state) {
        newest = state;
        notifyAll();
    }

    synchronized void submit(T task) {
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

    /** Whether it is so by a state that is such a one, or by the end. */
    synchronized boolean isInterrupted(Predicate<S> by) {
        return closed || (newest != null && by.test(newest));
    }

    /** The next task, if there is one; does not wait. */
    synchronized Optional<T> task() {
        return closed ? Optional.empty() : Optional.ofNullable(tasks.poll());
    }

    /** The newest state, once; does not wait. */
    synchronized Optional<S> state() {
        Optional<S> state = Optional.ofNullable(newest);
        newest = null;
        return state;
    }

    /** The newest state, once, if it is such a one; does not wait. */
    synchronized Optional<S> stateIf(Predicate<S> wanted) {
        return newest != null && wanted.test(newest) ? state() : Optional.empty();
    }

    /** Waits until there is something to do, or so many nanoseconds have gone by. */
    synchronized void await(long nanoseconds) throws InterruptedException {
        long start = System.nanoTime();
        for (long left = nanoseconds; !closed && newest == null && tasks.isEmpty() && left > 0; ) {
            wait(1 + TimeUnit.NANOSECONDS.toMillis(left));
            left = nanoseconds - (System.nanoTime() - start);
        }
    }
}
