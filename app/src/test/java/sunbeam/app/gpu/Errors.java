package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import sunbeam.precompute.text.Text;

/** Relative errors of a set of directions, ascending. */
record Errors(double[] sorted) {

    static Errors of(double[] relative) {
        double[] sorted = relative.clone();
        Arrays.sort(sorted);
        return new Errors(sorted);
    }

    double median() {
        return sorted[sorted.length / 2];
    }

    double percentile95() {
        return sorted[(int) (0.95 * (sorted.length - 1))];
    }

    double maximum() {
        return sorted[sorted.length - 1];
    }

    /** The promise of {@code --tolerance}: the median keeps it, the 95th percentile keeps three times it. */
    void assertWithin(double tolerance, String what) {
        assertThat(sorted.length).as("%s: directions that see something", what).isGreaterThan(4);
        assertThat(median()).as("%s: median of %s", what, this).isLessThanOrEqualTo(tolerance);
        assertThat(percentile95()).as("%s: 95th percentile of %s", what, this).isLessThanOrEqualTo(3 * tolerance);
    }

    @Override
    public String toString() {
        return Text.format(
                "%d errors: median %.2g, 95 %% %.2g, maximum %.2g", sorted.length, median(), percentile95(), maximum());
    }
}
