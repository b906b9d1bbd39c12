package sunbeam.app.terminal;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Something to be tidied up should the process be ended (Ctrl-C, SIGTERM) while this is open. */
public final class ShutdownHook implements AutoCloseable {
    private static final Set<ShutdownHook> OPEN = ConcurrentHashMap.newKeySet();

    private final Runnable action;
    private final Thread thread;

    /**
     * @param action runs on its own thread when the process ends while this is open; must be quick and thread-safe
     * @throws CancelledException when the process is being ended already
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

    /** Does what all that are open would do, now and on this thread: for an end of the process that runs no hooks. */
    public static void runAll() {
        OPEN.forEach(hook -> hook.action.run());
    }

    /** Whether the process is being ended, so that failures of the work that goes on mean nothing. */
    public static boolean isProcessEnding() {
        try {
            new ShutdownHook(() -> {}).close();
            return false;
        } catch (CancelledException cancelled) {
            return true;
        }
    }

    /** The action is needed no more. While the process is being ended it runs nevertheless. */
    @Override
    public void close() {
        OPEN.remove(this);
        try {
            Runtime.getRuntime().removeShutdownHook(thread);
        } catch (IllegalStateException shuttingDown) {
            // The hook is running or has run: nothing to take back.
        }
    }
}
