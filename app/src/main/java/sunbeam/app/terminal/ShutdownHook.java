package sunbeam.app.terminal;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Action that runs if the process is ended (Ctrl-C, SIGTERM) while this is open. The list of open ones belongs to the process, as Java's
 * own list of hooks does.
 */
public final class ShutdownHook implements AutoCloseable {
    private static final Set<ShutdownHook> OPEN = ConcurrentHashMap.newKeySet();

    private final Runnable action;
    private final Thread thread;

    /**
     * @param action action for a thread of its own; must be quick and thread-safe
     * @throws CancelledException if the process is being ended already
     */
    public ShutdownHook(Runnable action) {
        this.action = action;
        thread = new Thread(action, "sunbeam-shutdown");
        try {
            Runtime.getRuntime().addShutdownHook(thread);
            OPEN.add(this);
        } catch (IllegalStateException shuttingDown) {
            CancelledException cancelled = new CancelledException();
            cancelled.addSuppressed(shuttingDown);
            throw cancelled;
        }
    }

    /** Runs the actions of all open hooks on this thread: for an end of the process that runs no hooks. */
    public static void runAll() {
        OPEN.forEach(hook -> hook.action.run());
    }

    /** True while the process is being ended; failures of work that goes on mean nothing then. */
    public static boolean isProcessEnding() {
        try {
            new ShutdownHook(() -> {}).close();
            return false;
        } catch (CancelledException cancelled) {
            return true;
        }
    }

    /** Withdraws the action. While the process is being ended it runs nevertheless. */
    @Override
    public void close() {
        OPEN.remove(this);
        try {
            Runtime.getRuntime().removeShutdownHook(thread);
        } catch (IllegalStateException shuttingDown) {
            // The hook is running or has run.
        }
    }
}
