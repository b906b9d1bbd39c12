package sunbeam.precompute.table;

/** A table file that cannot be used; the message names the file, what is wrong and the remedy. */
public final class TableException extends RuntimeException {
    public TableException(String message) {
        super(message);
    }

    public TableException(String message, Throwable cause) {
        super(message, cause);
    }
}
