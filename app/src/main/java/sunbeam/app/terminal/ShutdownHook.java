package sunbeam.app.terminal;

/** Action that runs if the process is ended (Ctrl-C, SIGTERM) while this hook is open. */
public final class ShutdownHook implements AutoCloseable {
    private final Thread thread;

    /** Runs the action on a thread of its own; it must be quick and thread-safe. Throws CancelledException if the process is ending. */
    public ShutdownHook(Runnable action) {
        thread = new Thread(action, "sunbeam-shutdown");
        try {
            Runtime.getRuntime().addShutdownHook(thread);
        } catch (IllegalStateException shuttingDown) {
            throw new CancelledException();
        }
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
