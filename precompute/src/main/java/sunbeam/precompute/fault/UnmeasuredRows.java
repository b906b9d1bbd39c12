package sunbeam.precompute.fault;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;
import sunbeam.precompute.prepare.Crop;

/**
 * Rows that are no measurement: missing (a half of their samples or more), of one height all along, or the row before once
 * more. Gratings that somebody computed have such rows, too: all of them, or many at equal distances, or flat ground that goes on in
 * their neighbours. They are no faults.
 */
final class UnmeasuredRows {
    // Of the samples of most rows.
    private static final double SCATTERED = 0.9;
    // Fewer are alike by chance, or drawn.
    private static final int FEWEST_COLUMNS = 16;
    private static final int FEWEST_ROWS = 16;
    // Measured rows beside each place where a scan stopped; a computed surface has a crest, of two equal rows, in each
    // period.
    private static final int ROWS_A_FAULT = 8;
    // Of a row's samples at its neighbour's one height: flat ground.
    private static final double GROUND = 0.1;
    // Samples in line with exactly one height: more than quantised heights have by chance where the next row has
    // another.
    private static final int FEWEST_BEGUN = 4;
    // Of the heights' largest: rounding to 32 bits of rows that were levelled together.
    private static final double ROUNDING = 4e-7;
    // Of what rows differ by elsewhere: near a smooth surface's crest they differ by less.
    private static final double ABRUPT = 0.5;
    private static final int MOST_RUNS_TOLD = 4;

    private final Measured scan;
    private final RowSteps steps;
    private final BitSet missing = new BitSet();
    private final BitSet flat = new BitSet();
    private final BitSet repeated = new BitSet();

    UnmeasuredRows(Measured scan, RowSteps steps) {
        this.scan = scan;
        this.steps = steps;
        findMissing();
        if (scan.columns() >= FEWEST_COLUMNS && scan.rows() >= FEWEST_ROWS) {
            findFlat();
            findRepeated();
        }
    }

    /** All of them. */
    BitSet all() {
        BitSet all = (BitSet) missing.clone();
        all.or(flat);
        all.or(repeated);
        return all;
    }

    private void findMissing() {
        long samples = 0;
        for (int row = 0; row < scan.rows(); row++) {
            int count = 0;
            for (int column = 0; column < scan.columns(); column++) {
                count += Double.isFinite(scan.at(column, row)) ? 0 : 1;
            }
            missing.set(row, 2 * count >= scan.columns());
            samples += missing.get(row) ? count : 0;
        }
        // Samples that are missing here and there, as where light found no way back, stop no row.
        if (2 * missing.cardinality() > scan.rows() && samples < SCATTERED * missing.cardinality() * scan.columns()) {
            missing.clear();
        }
    }

    private void findFlat() {
        for (int row = 0; row < scan.rows(); row++) {
            flat.set(row, !missing.get(row) && isFlat(row));
        }
        for (int[] run : runs(flat)) {
            takeBegun(run[0], run[0] - 1, -1);
            takeBegun(run[0], run[1], 1);
        }
        int others = scan.rows() - flat.cardinality() - missing.cardinality();
        List<int[]> runs = runs(flat);
        boolean drawn = runs.size() * ROWS_A_FAULT > others
                || runs.stream().anyMatch(run -> isGround(run[0], run[0] - 1) || isGround(run[0], run[1]));
        if (drawn) {
            flat.clear();
        }
    }

    private boolean isFlat(int row) {
        for (int column = 1; column < scan.columns(); column++) {
            if (scan.at(column, row) != scan.at(0, row)) {
                return false;
            }
        }
        return true;
    }

    /** A row within which the one height of the next begins, or ends, and which is measured else: as little as that one. */
    private void takeBegun(int row, int neighbour, int away) {
        if (neighbour >= 0
                && neighbour < scan.rows()
                && !isGround(row, neighbour + away)
                && (begins(row, neighbour, 0, 1) || begins(row, neighbour, scan.columns() - 1, -1))) {
            flat.set(neighbour);
        }
    }

    /** Whether the first samples from a side on have a row's one height. */
    private boolean begins(int row, int neighbour, int first, int step) {
        for (int i = 0; i < FEWEST_BEGUN; i++) {
            if (scan.at(first + i * step, neighbour) != scan.at(0, row)) {
                return false;
            }
        }
        return true;
    }

    /** Whether a row's one height goes on in its neighbour, if it has one that is not flat itself. */
    private boolean isGround(int row, int neighbour) {
        if (neighbour < 0 || neighbour >= scan.rows()) {
            return false;
        }
        int same = 0;
        for (int column = 0; column < scan.columns(); column++) {
            same += scan.at(column, neighbour) == scan.at(0, row) ? 1 : 0;
        }
        return same >= GROUND * scan.columns();
    }

    private void findRepeated() {
        double slack = ROUNDING * steps.largest();
        BitSet found = new BitSet();
        for (int row = 1; row < scan.rows(); row++) {
            boolean told = flat.get(row) || missing.get(row) || missing.get(row - 1);
            found.set(row, !told && isSame(row, slack));
        }
        BitSet told = (BitSet) missing.clone();
        told.or(flat);
        double typical = steps.typicalSpread(found, told);
        int others = scan.rows() - found.cardinality() - told.cardinality();
        List<int[]> runs = runs(found);
        if (!(typical > 0) || runs.size() * ROWS_A_FAULT > others) {
            return;
        }
        for (int[] run : runs) {
            if (Math.max(steps.spread(run[0] - 2), steps.spread(run[1] - 1)) >= ABRUPT * typical) {
                repeated.set(run[0], run[1]);
            }
        }
    }

    /** Whether a row differs from the one before by the same all along. */
    private boolean isSame(int row, double slack) {
        double first = Double.NaN;
        for (int column = 0; column < scan.columns(); column++) {
            double difference = scan.at(column, row) - scan.at(column, row - 1);
            if (Double.isNaN(first)) {
                first = difference;
            }
            if (Math.abs(difference - first) > slack) {
                return false;
            }
        }
        return Double.isFinite(first);
    }

    /** First and end of each unbroken run. */
    private static List<int[]> runs(BitSet rows) {
        List<int[]> runs = new ArrayList<>();
        for (int first = rows.nextSetBit(0); first >= 0; ) {
            int end = rows.nextClearBit(first);
            runs.add(new int[] {first, end});
            first = rows.nextSetBit(end);
        }
        return runs;
    }

    /** What is told of them, with the one part that is free of them all. */
    List<ScanFault> faults() {
        Optional<Crop> part = largestPart();
        List<ScanFault> faults = new ArrayList<>();
        if (!missing.isEmpty()) {
            faults.add(ScanFault.ofRows(words(missing) + " missing" + aborted(missing), part, share(missing)));
        }
        if (!flat.isEmpty()) {
            faults.add(ScanFault.ofRows(words(flat) + " of one height all along" + aborted(flat), part, share(flat)));
        }
        if (!repeated.isEmpty()) {
            boolean one = repeated.cardinality() == 1;
            // Whoever gives the scan's width for a picture that shows more than the scan gets lengths of another scale.
            String cause = part.filter(scan::isFramed).isPresent()
                    ? ", as in a picture with a margin, whose width must then be given with the margin"
                    : ", as where a line is stuck";
            faults.add(ScanFault.ofRows(
                    words(repeated) + (one ? " the row" : " each the row") + " above once more"
                            + (aborted(repeated).isEmpty() ? cause : aborted(repeated)),
                    part,
                    share(repeated)));
        }
        return faults;
    }

    private double share(BitSet rows) {
        return (double) rows.cardinality() / scan.rows();
    }

    private Optional<Crop> largestPart() {
        BitSet good = all();
        good.flip(0, scan.rows());
        return runs(good).stream()
                .max((a, b) -> Integer.compare(a[1] - a[0], b[1] - b[0]))
                .filter(run -> (long) (run[1] - run[0]) * scan.columns() >= 2)
                .map(run -> scan.rows(run[0], run[1]));
    }

    /** At one end: the scan was stopped. */
    private String aborted(BitSet rows) {
        List<int[]> runs = runs(rows);
        boolean atAnEnd = runs.size() == 1 && (runs.get(0)[0] == 0 || runs.get(0)[1] == scan.rows());
        return atAnEnd && rows.cardinality() > 1 ? ", as where a scan was stopped" : "";
    }

    /** "rows 3, 7 to 9 and 3 more of 128 (from the top) are". */
    private String words(BitSet rows) {
        StringJoiner told = new StringJoiner(", ");
        List<int[]> runs = runs(rows);
        int others = rows.cardinality();
        for (int[] run : runs.subList(0, Math.min(MOST_RUNS_TOLD, runs.size()))) {
            int first = scan.number(run[0]);
            int last = scan.number(run[1] - 1);
            told.add(first == last ? Integer.toString(first) : first + " to " + last);
            others -= run[1] - run[0];
        }
        return String.format(
                Locale.ROOT,
                "%s %s%s of %d (from the top) %s",
                rows.cardinality() == 1 ? "row" : "rows",
                told,
                others > 0 ? " and " + others + " more" : "",
                scan.whole().rows(),
                rows.cardinality() == 1 ? "is" : "are");
    }
}
