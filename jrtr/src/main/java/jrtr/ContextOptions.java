package jrtr;

/**
 * How a context is made.
 *
 * @param debugOutput whether the driver is asked to report its messages; some drivers are slower then
 */
public record ContextOptions(boolean debugOutput) {

    /** No debug output. */
    public static ContextOptions standard() {
        return new ContextOptions(false);
    }

    /** With debug output, where the driver has it. */
    public static ContextOptions withDebugOutput() {
        return new ContextOptions(true);
    }
}
