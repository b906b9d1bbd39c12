package sunbeam.app.terminal;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Action that runs if the process is ended (Ctrl-C, SIGTERM) while this hook is open. The set of open hooks is static, since the process is
 * ended as a whole.
 */
public final class ShutdownHook implements AutoCloseable {
    private static final Set<ShutdownHook> OPEN = ConcurrentHashMap.newKeySet();

    private final Runnable action;
    private final Thread thread;

    /** Runs the action on a thread of its own; it must be quick and thread-safe. Throws CancelledException if the process is ending. */
    public ShutdownHook(Runnable action) {
        this.action = action;
        thread = new Thread(action, "sunbeam-shutdown");
        try {
            Runtime.getRuntime().addShutdownHook(thread);
            OPEN.add(this);
        } catch (IllegalStateException shuttingDown) {
            throw new CancelledException();
        }
    }

    /** Runs the actions of all open hooks on this thread. Callers then end the process by {@code Runtime.halt}, which runs no hooks. */
    public static void runAll() {
        OPEN.forEach(hook -> hook.action.run());
    }

    /** True while the process is being ended. Failures of work that still runs are then to be ignored. */
    public static boolean isProcessEnding() {
        try {
            new ShutdownHook(() -> {}).close();
            return false;
        } catch (CancelledException cancelled) {
            return true;
        }
    }

    /** Withdraws the action. If the process is being ended already, the action runs nevertheless. */
    @Override
    public void close() {
        OPEN.remove(this);
        try {
            Runtime.getRuntime().removeShutdownHook(thread);
        } catch (IllegalStateException shuttingDown) {
            // The hook is running or has run.
        }
    }

    /** Thrown when the user ends the process; work stops without a message. */
    public static final class CancelledException extends RuntimeException {
        public CancelledException() {
            super("interrupted");
        }
    }
}
