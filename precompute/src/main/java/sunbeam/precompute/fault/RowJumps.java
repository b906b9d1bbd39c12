package sunbeam.precompute.fault;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.units.Lengths;

/**
 * Rows that lie higher or lower as a whole than their neighbours: steps between two rows, as a slip of the scanner leaves them, and
 * offsets that each row has for itself. A surface with lines along the rows has such steps, too, but smoothly or at equal
 * distances; and one that changes from row to row alone is nobody's scan.
 */
final class RowJumps {
    private static final int FEWEST_ROWS = 32;
    private static final int FEWEST_COLUMNS = 16;
    // Robust deviations of all steps, and of what columns stray by: the surface itself makes no such step.
    private static final double STANDING_OUT = 10;
    private static final double ABOVE_SPREAD = 4;
    // All columns jump by the same: they stray no more than so many times what they do elsewhere.
    private static final double TOGETHER = 3;
    // Of the median step, between it and the mean one: lines that slip sideways have other means.
    private static final double ALL_ALIKE = 0.25;
    private static final int MOST_STEPS = 3;
    // Rows on either side over which a step must not be taken back, and by how much of it.
    private static final int LASTING_ROWS = 8;
    private static final double TAKEN_BACK = 0.5;
    // Of a step at the border, in others.
    private static final double LIKE = 0.3;
    // Of what columns stray by: less is chance.
    private static final double LEAST_OFFSET = 0.5;
    // Correlation of steps with their neighbours: of independent offsets -0.5, of a walk 0, of a smooth surface near 1.
    private static final double LARGEST_WITH_NEXT = 0.3;
    // With farther ones: of a grating near 1, of chance up to three deviations.
    private static final double LARGEST_BEYOND = 0.35;

    private final Measured scan;
    private final RowSteps steps;
    private final BitSet left;
    private final double spread;
    private final double middle;
    private final double deviation;

    /** @param unmeasured rows that are left out */
    RowJumps(Measured scan, RowSteps steps, BitSet unmeasured) {
        this.scan = scan;
        this.steps = steps;
        this.left = new BitSet();
        for (int row = 0; row < steps.pairs(); row++) {
            boolean counts = !unmeasured.get(row) && !unmeasured.get(row + 1);
            left.set(row, counts && !Double.isNaN(steps.step(row)));
        }
        double[] all = left.stream().mapToDouble(steps::step).toArray();
        spread = steps.typicalSpread(new BitSet(), unmeasured);
        middle = all.length == 0 ? 0 : RowSteps.median(all.clone());
        deviation = all.length == 0 ? 0 : RowSteps.spreadOf(all);
    }

    List<ScanFault> faults() {
        if (left.cardinality() < FEWEST_ROWS || scan.columns() < FEWEST_COLUMNS || !(spread > 0)) {
            return List.of();
        }
        List<Integer> jumps = jumps();
        List<ScanFault> faults = new ArrayList<>();
        if (!jumps.isEmpty() && jumps.size() <= MOST_STEPS) {
            jumps.forEach(row -> faults.add(step(row)));
        }
        offsets(jumps.size() <= MOST_STEPS ? jumps : List.of()).ifPresent(faults::add);
        return faults;
    }

    private List<Integer> jumps() {
        double least = Math.max(STANDING_OUT * deviation, ABOVE_SPREAD * spread);
        List<Integer> steep = left.stream()
                .filter(row -> Math.abs(steps.step(row) - middle) > least)
                .filter(row -> steps.spread(row) <= TOGETHER * spread)
                .filter(row -> Math.abs(steps.meanStep(row) - steps.step(row)) <= ALL_ALIKE * Math.abs(steps.step(row)))
                .boxed()
                .toList();
        List<Integer> lasting = steep.stream().filter(this::lasts).toList();
        return isTakenBack(lasting)
                ? List.of()
                : lasting.stream()
                        .filter(row -> !isAtABorder(row) || !hasLikesThatAreTakenBack(row, steep))
                        .toList();
    }

    /** Up and down again by as much: a ridge or groove along the rows. */
    private boolean isTakenBack(List<Integer> jumps) {
        for (int i = 1; i < jumps.size(); i++) {
            double before = steps.step(jumps.get(i - 1)) - middle;
            double after = steps.step(jumps.get(i)) - middle;
            if (before * after < 0 && Math.abs(before + after) <= ALL_ALIKE * Math.abs(before)) {
                return true;
            }
        }
        return false;
    }

    /** Where what would take it back may lie outside the scan. */
    private boolean isAtABorder(int row) {
        return row < LASTING_ROWS || row + LASTING_ROWS >= steps.pairs();
    }

    /** A structure along the rows, which the border cuts, shows itself elsewhere in the scan. */
    private boolean hasLikesThatAreTakenBack(int row, List<Integer> steep) {
        return steep.stream()
                .anyMatch(other -> !lasts(other)
                        && Math.abs(steps.step(other) - middle) > LIKE * Math.abs(steps.step(row) - middle));
    }

    /** Whether the rows on either side do not take the step back: a single row that stands out is no step. */
    private boolean lasts(int row) {
        double step = steps.step(row) - middle;
        double before = 0;
        double after = 0;
        boolean lasts = true;
        for (int i = 1; i <= LASTING_ROWS; i++) {
            before += left.get(Math.max(0, row - i)) && row >= i ? steps.step(row - i) - middle : 0;
            after += left.get(row + i) ? steps.step(row + i) - middle : 0;
            lasts &= before / step > -TAKEN_BACK && after / step > -TAKEN_BACK;
        }
        return lasts;
    }

    private ScanFault step(int row) {
        return ScanFault.levelledBy(
                Levelling.MEDIAN_ROWS,
                String.format(
                        Locale.ROOT,
                        "all heights jump by %s between rows %d and %d of %d (from the top)",
                        Lengths.rounded(Math.abs(steps.step(row)), 2),
                        scan.number(row),
                        scan.number(row + 1),
                        scan.whole().rows()));
    }

    /** @param jumps that are told of by themselves */
    private Optional<ScanFault> offsets(List<Integer> jumps) {
        int[] rows = left.stream().filter(row -> !jumps.contains(row)).toArray();
        if (deviation < LEAST_OFFSET * spread || correlation(rows, 1) > LARGEST_WITH_NEXT) {
            return Optional.empty();
        }
        for (int lag = 2; lag <= rows.length / 4; lag++) {
            if (correlation(rows, lag) > LARGEST_BEYOND) {
                return Optional.empty();
            }
        }
        return Optional.of(ScanFault.levelledBy(
                Levelling.MEDIAN_ROWS,
                String.format(
                        Locale.ROOT,
                        "rows lie higher or lower than their neighbours by %s rms, each by itself",
                        Lengths.rounded(deviation, 2))));
    }

    /** Of steps that are cut at three deviations, lest a few large ones decide. */
    private double correlation(int[] rows, int lag) {
        double product = 0;
        double square = 0;
        for (int i = 0; i < rows.length; i++) {
            double here = cut(rows[i]);
            square += here * here;
            product += i + lag < rows.length ? here * cut(rows[i + lag]) : 0;
        }
        return square > 0 ? product / square : 0;
    }

    private double cut(int row) {
        return Math.max(-3 * deviation, Math.min(3 * deviation, steps.step(row) - middle));
    }
}
