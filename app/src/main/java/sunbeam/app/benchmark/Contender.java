package sunbeam.app.benchmark;

import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;

/**
 * A plan to be timed.
 *
 * @param label how it is called in the report
 */
record Contender(String label, Plan plan) {

    /** What the plan comes to, in a few words. */
    String description() {
        String terms = plan.expansion().terms() + " " + plan.expansion().kind().label() + " terms, ";
        Sampling sampling = plan.sampling();
        if (sampling instanceof Sampling.Bins bins) {
            int side = 2 * bins.neighbourhood().radius() + 1;
            return terms + side + " x " + side + " bins, " + bins.wavelengths().count() + " wavelengths";
        }
        if (sampling instanceof Sampling.Grid grid) {
            return terms + grid.interpolation().taps() + " taps, wavelengths on the grid";
        }
        return terms + "wavelengths around orders";
    }
}
