package sunbeam.precompute.plan;

/** What was asked for cannot be planned; the message is one line that says why and what helps. */
public class PlanException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public PlanException(String message) {
        super(message);
    }
}
