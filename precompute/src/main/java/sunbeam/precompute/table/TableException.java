package sunbeam.precompute.table;

/** Unusable table in the cache; the message names its file and the problem. */
public final class TableException extends RuntimeException {
    public TableException(String problem) {
        super(problem);
    }
}
