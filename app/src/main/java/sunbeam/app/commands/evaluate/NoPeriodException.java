package sunbeam.app.commands.evaluate;

/** A surface whose response gives no period; the message says by which figure, and what may be done. */
public final class NoPeriodException extends RuntimeException {
    public NoPeriodException(String message) {
        super(message);
    }
}
