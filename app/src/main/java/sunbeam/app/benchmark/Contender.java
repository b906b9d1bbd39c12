package sunbeam.app.benchmark;

import sunbeam.app.setup.MethodFactory;

/**
 * A planned method to be timed.
 *
 * @param label how it is called in the report
 */
record Contender(String label, MethodFactory method) {

    /** What the plan comes to, in a few words. */
    String description() {
        return method.summary();
    }
}
