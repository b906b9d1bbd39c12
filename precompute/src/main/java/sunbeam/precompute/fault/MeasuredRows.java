package sunbeam.precompute.fault;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.stream.IntStream;
import sunbeam.precompute.fault.ScanFaults.ScanFault;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.text.Text;

/**
 * Detection of rows without a measurement: missing, constant, or equal to the row before. A computed surface has many such rows; then all
 * rows count as measured.
 */
final class MeasuredRows {
    // Single samples are often missing.
    private static final double MISSING = 0.9;
    // Measured rows per run of unmeasured ones; a computed surface has more runs, two equal rows per crest.
    private static final int ROWS_PER_RUN = 16;
    // Relative to the largest height: the rounding to 32-bit floats of repeated rows that were leveled afterwards.
    private static final double ROUNDING = 4e-7;
    private static final int MOST_RUNS_NAMED = 4;

    private final HeightMap scan;
    private final BitSet unmeasured = new BitSet();

    MeasuredRows(HeightMap scan) {
        this.scan = scan;
        double slack = ROUNDING * Math.max(Math.abs(scan.minimum()), Math.abs(scan.maximum()));
        for (int row = 0; row < scan.rows(); row++) {
            unmeasured.set(row, isMissing(row) || isConstant(row, -1, 0));
        }
        boolean noisy = rowsDiffer();
        BitSet repeated = new BitSet();
        for (int row = 1; row < scan.rows() && noisy; row++) {
            repeated.set(row, isConstant(row, row - 1, slack));
        }
        // A single row that equals the one before may be the crest of a symmetric surface.
        runs(repeated).stream().filter(run -> run[1] - run[0] > 1).forEach(run -> unmeasured.set(run[0], run[1]));
        int measured = scan.rows() - unmeasured.cardinality();
        if (runs(unmeasured).size() * ROWS_PER_RUN > measured) {
            unmeasured.clear();
        }
    }

    boolean isPair(int row) {
        return row + 1 < scan.rows() && !unmeasured.get(row) && !unmeasured.get(row + 1);
    }

    private boolean rowsDiffer() {
        double[] heights = scan.heights();
        long same = IntStream.range(scan.columns(), heights.length)
                .filter(i -> heights[i] == heights[i - scan.columns()])
                .count();
        long unlike = (long) heights.length - (long) unmeasured.cardinality() * scan.columns() - same;
        return 2 * unlike > heights.length - (long) unmeasured.cardinality() * scan.columns();
    }

    private boolean isMissing(int row) {
        return IntStream.range(0, scan.columns())
                        .filter(column -> !Double.isFinite(scan.at(column, row)))
                        .count()
                >= MISSING * scan.columns();
    }

    /** True if a row minus another, or the row itself if {@code other} is negative, is constant within {@code slack} meters. */
    private boolean isConstant(int row, int other, double slack) {
        double first = Double.NaN;
        for (int column = 0; column < scan.columns(); column++) {
            double difference = scan.at(column, row) - (other < 0 ? 0 : scan.at(column, other));
            first = Double.isNaN(first) ? difference : first;
            if (Math.abs(difference - first) > slack) {
                return false;
            }
        }
        return Double.isFinite(first);
    }

    /** Each run: its first row and the row after its last. */
    private static List<int[]> runs(BitSet rows) {
        List<int[]> runs = new ArrayList<>();
        for (int first = rows.nextSetBit(0); first >= 0; ) {
            int end = rows.nextClearBit(first);
            runs.add(new int[] {first, end});
            first = rows.nextSetBit(end);
        }
        return runs;
    }

    /**
     * Describes the rows without a measurement and the largest part of the scan without them; the place is that of the examined samples.
     */
    Optional<ScanFault> fault(HeightMap whole, Crop.Samples place) {
        if (unmeasured.isEmpty()) {
            return Optional.empty();
        }
        BitSet measured = (BitSet) unmeasured.clone();
        measured.flip(0, scan.rows());
        Optional<Crop> part = runs(measured).stream()
                .max(Comparator.comparingInt(run -> run[1] - run[0]))
                .map(run -> new Crop.Samples(
                                place.firstColumn(),
                                place.endColumn(),
                                place.firstRow() + run[0],
                                place.firstRow() + run[1])
                        .area(whole));
        String words = Text.format(
                "%s %s of %d (from the top) hold no measurement: missing, constant, or equal to the row above",
                unmeasured.cardinality() == 1 ? "row" : "rows", numbers(place.firstRow() + 1), whole.rows());
        double share = (double) unmeasured.cardinality() / scan.rows();
        return Optional.of(new ScanFault(words, part, Optional.empty(), share, ""));
    }

    /** Returns "3, 7 to 9 and 3 more". */
    private String numbers(int firstNumber) {
        StringJoiner text = new StringJoiner(", ");
        List<int[]> runs = runs(unmeasured);
        int others = unmeasured.cardinality();
        for (int[] run : runs.subList(0, Math.min(MOST_RUNS_NAMED, runs.size()))) {
            int first = run[0] + firstNumber;
            int last = run[1] - 1 + firstNumber;
            text.add(first == last ? Integer.toString(first) : first + " to " + last);
            others -= run[1] - run[0];
        }
        return text + (others > 0 ? " and " + others + " more" : "");
    }
}
