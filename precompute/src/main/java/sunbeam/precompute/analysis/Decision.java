package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.Predicate;
import sunbeam.precompute.analysis.GratingPeriod.Certainty;

/**
 * Table of decisions on a wave: of its rows, in this order, the first whose condition holds decides. {@code KnownSurfaceTest} counts that at most
 * 1 in 200 surfaces without order are called sure and 3 in 100 probable. docs/evaluation.md has its rows.
 */
enum Decision {
    FINE_RELIEF(
            Certainty.NONE,
            "share below 0.08, half of the relief finer than light resolves",
            wave -> isFaint(wave) && wave.unseen() > 0.5),
    FAINT(Certainty.NONE, "share below 0.08", Decision::isFaint),
    ALL_DIRECTIONS(
            Certainty.ALL_DIRECTIONS,
            "4 periods, ring 4, contrast below 40 (of a broad line 10), lines below 0.3",
            wave -> !wave.isStated()
                    && wave.periods() >= 4
                    && wave.ring() >= 4
                    && wave.contrast() < (wave.broad() ? 10 : 40)
                    && wave.lines() < 0.3),
    TOO_FEW(
            Certainty.TOO_LITTLE,
            "fewer than 3 periods; order, or lines 0.3 and contrast 10",
            wave -> wave.periods() < 3 && (isOrder(wave) || (wave.lines() >= 0.3 && wave.contrast() >= 10))),
    UNRESOLVED(
            Certainty.TOO_LITTLE,
            "fewer than 3 samples a period; order, or as in the next row",
            wave -> wave.samples() < 3 && (isOrder(wave) || isLikely(wave))),
    LIKELY(
            Certainty.PROBABLE,
            "no order; contrast 10; strays 0.5 or prominence 15; lines 0.2, prominence 4 (from contrast 60 on 15), significance 40, 3.5"
                    + " periods",
            wave -> !isOrder(wave) && isLikely(wave)),
    POSSIBLE(
            Certainty.TOO_LITTLE,
            "no order; lines 0.15, prominence 3",
            wave -> !isOrder(wave) && wave.lines() >= 0.15 && wave.prominence() >= 3),
    NOISE(Certainty.NONE, "no order", wave -> !isOrder(wave)),
    FEW(Certainty.PROBABLE, "fewer than 4 periods", wave -> wave.periods() < 4),
    UNDERSAMPLED(Certainty.PROBABLE, "fewer than 4 samples a period", wave -> wave.samples() < 4),
    UNEVEN(Certainty.PROBABLE, "interval wider than a fifth of the period", wave -> 2 * wave.halfWidth() > 0.2),
    SURE(Certainty.SURE, "else", wave -> true);

    // Probability that the strongest of a few random waves has such a share, or that noise in one direction has such a
    // peak, on whose period the parts of the scan agree so well.
    private static final double FALSE_ALARMS = 0.005;
    // Likewise of fewer than four periods, which are never sure.
    private static final double FALSE_PROBABLE = 0.03;
    // Half widths of intervals of noise, in periods over the scan, are spread evenly up to this one.
    private static final double DISAGREEING = 1;
    // Likewise of a wave that is told: parts of the scan that differ by more have no phase in common.
    private static final double AGREEING = 0.5;
    private static final double HANN_BINS = 1.5;

    final Certainty certainty;
    private final String condition;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final Predicate<Evidence> holds;

    Decision(Certainty certainty, String condition, Predicate<Evidence> holds) {
        this.certainty = certainty;
        this.condition = condition;
        this.holds = holds;
    }

    /** Returns the row of the table in docs/evaluation.md. */
    String row() {
        return "| " + condition + " | `" + certainty.name().toLowerCase(Locale.ROOT) + "` |";
    }

    static Decision of(Evidence wave) {
        return Arrays.stream(values())
                .filter(row -> row.holds.test(wave))
                .findFirst()
                .orElseThrow();
    }

    private static boolean isFaint(Evidence wave) {
        return wave.share() < 0.08 && !wave.isStated();
    }

    /** Whether the surface is nearly one wave, or a wave stands out of its neighborhood. */
    private static boolean isOrder(Evidence wave) {
        // Powers of random waves are distributed exponentially: n + 1 of them, each of another number of periods.
        double chance = (wave.periods() + 1) * Math.pow(1 - wave.lines(), wave.periods());
        boolean alone = chance <= falseAlarms(wave);
        boolean standsOut = isPeak(wave) && wave.lines() * wave.prominence() >= 4 && wave.significance() >= 40;
        boolean directed = wave.contrast() >= 10 || wave.lines() >= 0.27;
        boolean grown = wave.broad() && wave.contrast() >= 20 && wave.prominence() >= 16;
        return wave.isStated() || (directed && (alone || standsOut || grown));
    }

    /** Whether noise has no such peak: the mean of a few independent powers varies, so that a peak's ratio to it follows Fisher's distribution. */
    private static boolean isPeak(Evidence wave) {
        double beside = LineMeasures.BESIDE * wave.periods() / HANN_BINS;
        double ratio = wave.prominence() * Math.log(2);
        double chance = (wave.periods() + 1) * Math.pow(1 + ratio / beside, -beside);
        return chance * Math.min(1, wave.strays() / DISAGREEING) <= falseAlarms(wave);
    }

    private static double falseAlarms(Evidence wave) {
        return wave.periods() < 4 ? FALSE_PROBABLE : FALSE_ALARMS;
    }

    /** Straight lines of noise, whose contrast is higher, have few independent waves, of which one may be this strong. */
    private static boolean isLikely(Evidence wave) {
        boolean agrees = wave.strays() <= AGREEING || wave.prominence() >= 15;
        return wave.contrast() >= 10
                && agrees
                && wave.lines() >= 0.2
                && wave.prominence() >= (wave.contrast() >= 60 ? 15 : 4)
                && wave.significance() >= 40
                && wave.periods() >= 3.5;
    }
}
