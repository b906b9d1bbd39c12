package sunbeam.app.terminal;

/** The process is being ended by the user; work stops without a message. */
public final class CancelledException extends RuntimeException {
    public CancelledException() {
        super("interrupted");
    }
}
