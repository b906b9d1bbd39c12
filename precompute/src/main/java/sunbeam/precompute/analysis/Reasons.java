package sunbeam.precompute.analysis;

import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Words for the rows of the table of decisions. */
final class Reasons {
    private Reasons() {}

    /** Returns why a period is not sure; empty if it is. */
    static String of(Decision decision, Evidence evidence, SpatialFrequency wave, Hypothesis asked) {
        String about = Lengths.rounded(wave.period(), 2);
        String strongest = asked.nothing() + "; the strongest wave, of about " + about;
        String more = "too little to judge: %s; use a larger scan, or state that it is periodic";
        return switch (decision) {
            case FINE_RELIEF -> "no order found: most of the relief is finer than light resolves (190 nm)";
            case FAINT ->
                strongest + Text.format(", explains only %.0f %% of the heights' variance", 100 * evidence.share());
            case ALL_DIRECTIONS -> "no grating found: waves of about " + about + " run in nearly all directions alike";
            case POSSIBLE ->
                Text.format(
                        more,
                        Text.format(
                                "a wave of about %s may be there, with %.0f %% of the heights' variance",
                                about, 100 * evidence.lines()));
            case NOISE -> strongest + ", is no stronger than one of noise";
            case UNRESOLVED ->
                Text.format(
                        "too little to judge: %.1f samples a period of about %s: perhaps the alias of a shorter one; scan finer",
                        evidence.samples(), about);
            case LIKELY ->
                Text.format(
                        "it holds %.0f %% of the heights' variance, little more than noise may",
                        100 * evidence.lines());
            case TOO_FEW -> Text.format(more, few(evidence.periods(), wave));
            case FEW -> Text.format("%.1f periods seen, too few for an interval", seen(evidence.periods()));
            case UNDERSAMPLED ->
                Text.format(
                        "%.1f samples a period: perhaps the alias of a shorter one; scan finer", evidence.samples());
            case UNEVEN -> "so uneven that this scan does not determine it to 10 %; use a larger one";
            case SURE -> "";
        };
    }

    static String few(double periods, SpatialFrequency wave) {
        return Text.format("only %.1f periods of about %s", seen(periods), Lengths.rounded(wave.period(), 2));
    }

    /** Rounds down: 2.99 periods are fewer than three. */
    private static double seen(double periods) {
        return Math.floor(10 * periods) / 10;
    }
}
