package sunbeam.app.viewer;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
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

    /** Shows this from now on. */
    synchronized void show(S state) {
        newest = state;
        notifyAll();
    }

    /** Does this soon; dropped once closed. */
    synchronized void submit(T task) {
        tasks.add(task);
        notifyAll();
    }

    /** Nothing more comes. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }

    synchronized boolean isClosed() {
        return closed;
    }

    /** Whether what is being done is out of date. */
    synchronized boolean isInterrupted() {
        return closed || newest != null;
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

    /** Waits until there is something to do. */
    synchronized void await() throws InterruptedException {
        while (!closed && newest == null && tasks.isEmpty()) {
            wait();
        }
    }

    /** As {@link #await()}, but no longer than until {@link System#nanoTime()} is {@code end}. */
    synchronized void awaitUntil(long end) throws InterruptedException {
        for (long left = milliseconds(end); !closed && newest == null && tasks.isEmpty() && left > 0; ) {
            wait(left);
            left = milliseconds(end);
        }
    }

    private static long milliseconds(long end) {
        return (end - System.nanoTime()) / 1_000_000;
    }
}
