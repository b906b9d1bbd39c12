package sunbeam.app.terminal;

/** Thrown when the user ends the process; work stops without a message. */
public final class CancelledException extends RuntimeException {
    public CancelledException() {
        super("interrupted");
    }
}
