package sunbeam.app.measure.benchmark;

import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;

/**
 * A planned method to be timed.
 *
 * @param label how it is called in the report
 * @param average which power its colours are made of; nothing for methods that know no average
 */
record Contender(String label, Optional<String> average, Method method, MethodPlan plan) {

    /** What the plan comes to, in a few words. */
    String description() {
        return plan.summary();
    }

    /** Its name and average in the report. */
    String name() {
        return average.map(kind -> String.format(Locale.ROOT, "%s, %s", label, kind))
                .orElse(label);
    }
}
