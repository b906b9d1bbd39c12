package sunbeam.app.measure.benchmark;

import sunbeam.precompute.method.MethodPlan;

/**
 * A planned method to be timed.
 *
 * @param label how it is called in the report
 */
record Contender(String label, MethodPlan method) {

    /** What the plan comes to, in a few words. */
    String description() {
        return method.summary();
    }
}
