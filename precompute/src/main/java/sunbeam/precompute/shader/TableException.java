package sunbeam.precompute.shader;

/** Error of a cached table that cannot be used; the message names the file and the problem. */
public final class TableException extends RuntimeException {
    public TableException(String problem) {
        super(problem);
    }
}
