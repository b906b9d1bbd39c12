package sunbeam.precompute.table;

/** A table file that cannot be used; the message names it, what is wrong and the remedy. */
public final class TableException extends RuntimeException {
    private final String problem;

    /** A problem without a remedy of its own. */
    public TableException(String problem) {
        super(problem);
        this.problem = problem;
    }

    /** The message is "problem; remedy". */
    public TableException(String problem, String remedy, Throwable cause) {
        super(problem + "; " + remedy, cause);
        this.problem = problem;
    }

    /** File and what is wrong with it, for those who have a remedy of their own. */
    public String problem() {
        return problem;
    }
}
