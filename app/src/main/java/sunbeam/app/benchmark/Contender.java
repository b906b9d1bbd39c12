package sunbeam.app.benchmark;

import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanReport;

/**
 * A plan to be timed.
 *
 * @param label how it is called in the report
 */
record Contender(String label, Plan plan) {

    /** What the plan comes to, in a few words. */
    String description() {
        return new PlanReport(plan).summary();
    }
}
