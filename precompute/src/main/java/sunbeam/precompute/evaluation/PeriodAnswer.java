package sunbeam.precompute.evaluation;

import java.util.OptionalDouble;
import sunbeam.precompute.analysis.PeriodEstimate;

/**
 * What is known of a surface's period: from the heights, whose uncertainty can be told, checked by the light. Where both
 * differ, the interval reaches from one to the other.
 *
 * @param heights from the phase of the heights' wave
 * @param light the ridge of the power, metres; empty where it shows none near the heights' period
 * @param of which light
 */
public record PeriodAnswer(PeriodEstimate heights, OptionalDouble light, Light of) {
    /** Whose power. */
    public enum Light {
        /** The scan alone, faded to zero at its border. */
        SCAN_ALONE,
        /** The mean over all positions of the window on the repeated scan. */
        ALL_POSITIONS,
        /** None: under the window, orders of such a period run into each other. */
        NOT_TOLD_APART,
        /** None: where the lines jump, the whole scan's ridge lies beside each piece's. */
        DRAWN_BY_SLIPS
    }

    /** Metres. */
    public double period() {
        return heights.period();
    }

    /** Of the interval that holds the period with a probability of 95 %, metres. */
    public double low() {
        return Math.min(heights.low(), light.orElse(heights.low()));
    }

    /** Of that interval, metres. */
    public double high() {
        return Math.max(heights.high(), light.orElse(heights.high()));
    }

    /** Whether the light lies outside of what the heights allow. */
    public boolean disagree() {
        return low() < heights.low() || high() > heights.high();
    }
}
