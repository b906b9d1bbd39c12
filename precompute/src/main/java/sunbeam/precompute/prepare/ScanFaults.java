package sunbeam.precompute.prepare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Preparation.Spikes;
import sunbeam.precompute.units.Lengths;

/**
 * Detection of rows without a measurement, and of rows that lie higher or lower as a whole than their neighbors. The offset between two
 * rows is the median over the columns of their difference; the spread of the differences (1.4826 times their median distance from the
 * offset) measures the surface's own variation. Lines of a surface along the rows cause offsets too, but these change smoothly, are
 * periodic, or come in pairs, one up and one down.
 */
public final class ScanFaults {
    private static final int FEWEST = 16;
    // Evenly spaced: the error of their median is a twelfth of their spread.
    private static final int MOST_COLUMNS = 256;
    // Least jump, in robust deviations of all steps (which are sqrt(1.5) as large as those of random offsets), and in
    // spreads of the columns.
    private static final double JUMP_DEVIATIONS = 8;
    // Ratio of a jump to the edges of the surface's own lines.
    private static final double STANDS_OUT = 2;
    // Difference between the offsets before and after a jump, relative to it; larger at a corner of the surface.
    private static final double LARGEST_BEND = 0.5;
    private static final double JUMP_SPREADS = 4;
    // Relative to the spread in other rows.
    private static final double LARGEST_JUMP_SPREAD = 3;
    // Difference between a jump's mean and median, and between jumps up and down of a ridge, per jump.
    private static final double ALIKE = 0.25;
    // More jumps belong to the surface.
    private static final int MOST_JUMPS = 3;
    // In spreads of the columns; smaller deviations of all offsets arise by chance.
    private static final double LEAST_OFFSET = 0.5;
    // Correlation of neighbors: -0.5 for independent rows, 0 for a random walk, near 1 for a smooth surface.
    private static final double LARGEST_WITH_NEXT = 0.3;
    // Correlation of offsets farther apart: near 1 for a grating. Three standard deviations of chance for 75 rows.
    private static final double LARGEST_BEYOND = 0.35;

    private final List<Offset> offsets;
    private final double spread;
    private final double medianOffset;
    private final double deviation;

    /** @param step median beyond those of the rows before and after, of which lines along the rows have much the same */
    private record Offset(int row, double median, double mean, double spread, double step, double bend) {
        double size() {
            return Math.abs(step);
        }

        Offset between(Offset before, Offset after) {
            double neighbors = 0.5 * (before.median + after.median);
            return new Offset(row, median, mean, spread, median - neighbors, Math.abs(before.median - after.median));
        }
    }

    private ScanFaults(HeightMap scan, MeasuredRows measured) {
        List<Offset> rows = IntStream.range(0, scan.rows() - 1)
                .parallel()
                .filter(row -> measured.unmeasured.get(row, row + 2).isEmpty())
                .mapToObj(row -> offset(scan, row))
                .filter(offset -> Double.isFinite(offset.median))
                .toList();
        this.offsets = IntStream.range(0, rows.size())
                .mapToObj(i ->
                        rows.get(i).between(rows.get(Math.max(0, i - 1)), rows.get(Math.min(i + 1, rows.size() - 1))))
                .toList();
        this.spread = median(offsets.stream().mapToDouble(Offset::spread));
        this.medianOffset = median(offsets.stream().mapToDouble(Offset::median));
        this.deviation = Spikes.GAUSSIAN
                * median(offsets.stream().mapToDouble(offset -> Math.abs(offset.median - medianOffset)));
    }

    /**
     * Returns the faults of raw heights, with tilt and missing samples: rows without a measurement first, then offsets; throws
     * IllegalArgumentException if the crop leaves the scan or holds fewer than two samples.
     */
    public static List<ScanFault> in(HeightMap whole, Optional<Crop> crop) {
        Crop.Samples place = crop.map(part -> part.samples(whole)).orElseGet(() -> Crop.Samples.allOf(whole));
        HeightMap scan = crop.isPresent() ? crop.get().apply(whole) : whole;
        if (scan.rows() < FEWEST || scan.columns() < FEWEST) {
            return List.of();
        }
        MeasuredRows measured = new MeasuredRows(scan);
        List<ScanFault> faults = new ArrayList<>();
        measured.fault(whole, place).ifPresent(faults::add);
        faults.addAll(new ScanFaults(scan, measured).offsetFaults(whole, place));
        return faults;
    }

    /** Returns what the next row is higher, in meters, in evenly spaced columns where both rows are measured. */
    private static double[] differences(HeightMap scan, int row) {
        int stride = (scan.columns() + MOST_COLUMNS - 1) / MOST_COLUMNS;
        double[] heights = scan.heights();
        return IntStream.range(0, scan.columns() / stride)
                .map(i -> row * scan.columns() + i * stride)
                .mapToDouble(i -> heights[i + scan.columns()] - heights[i])
                .filter(Double::isFinite)
                .toArray();
    }

    private static Offset offset(HeightMap scan, int row) {
        double[] differences = differences(scan, row);
        double median = median(Arrays.stream(differences));
        double spread =
                Spikes.GAUSSIAN * median(Arrays.stream(differences).map(difference -> Math.abs(difference - median)));
        return new Offset(row, median, Arrays.stream(differences).average().orElse(Double.NaN), spread, 0, 0);
    }

    private static double median(DoubleStream values) {
        return StatUtils.percentile(values.toArray(), 50);
    }

    private List<ScanFault> offsetFaults(HeightMap whole, Crop.Samples place) {
        if (offsets.size() < FEWEST || !(spread > 0)) {
            return List.of();
        }
        List<Offset> jumps = jumps();
        List<ScanFault> faults = new ArrayList<>();
        String rows = " of " + whole.rows() + " (from the top)";
        if (isBlock(jumps)) {
            Offset jump = jumps.get(0);
            faults.add(leveled("rows " + (place.firstRow() + jump.row + 2) + " to "
                    + (place.firstRow() + jumps.get(1).row + 1) + rows + " lie "
                    + Lengths.rounded(jump.size(), 2) + (jump.step > 0 ? " higher" : " lower")
                    + " than the others, all columns alike: the scanner, or a ridge along the rows"));
        } else {
            for (Offset jump : jumps) {
                String height = Lengths.rounded(jump.size(), 2);
                int above = place.firstRow() + jump.row + 1;
                faults.add(leveled(
                        "all heights jump by " + height + " between rows " + above + " and " + (above + 1) + rows));
            }
        }
        double[] others = offsets.stream()
                .filter(offset -> !jumps.contains(offset))
                .mapToDouble(offset -> Math.max(-3 * deviation, Math.min(3 * deviation, offset.median - medianOffset)))
                .toArray();
        if (deviation >= LEAST_OFFSET * spread && areIndependent(others)) {
            faults.add(leveled("rows have offsets of " + Lengths.rounded(deviation, 2) + " rms from their neighbors"));
        }
        return faults;
    }

    private static ScanFault leveled(String words) {
        return new ScanFault(words, Optional.empty(), Optional.of(Leveling.MEDIAN_ROWS), List.of(), "");
    }

    /** None if there are too many, or several jumps up and down by the same amount, as at ridges along the rows. */
    private List<Offset> jumps() {
        double usual = Spikes.GAUSSIAN * median(offsets.stream().mapToDouble(Offset::size));
        List<Offset> highest = IntStream.range(0, offsets.size())
                .filter(i -> IntStream.of(i - 1, i + 1)
                        .filter(other -> other >= 0 && other < offsets.size())
                        .allMatch(other ->
                                offsets.get(other).size() <= offsets.get(i).size()))
                .mapToObj(offsets::get)
                .filter(offset -> offset.bend <= LARGEST_BEND * offset.size())
                .sorted(Comparator.comparingDouble(offset -> -offset.size()))
                .toList();
        double others = highest.size() > MOST_JUMPS ? highest.get(MOST_JUMPS).size() : 0;
        double least = DoubleStream.of(JUMP_DEVIATIONS * usual, JUMP_SPREADS * spread, STANDS_OUT * others)
                .max()
                .orElseThrow();
        List<Offset> steep = highest.stream()
                .filter(offset -> offset.size() > least)
                .sorted(Comparator.comparingInt(Offset::row))
                .toList();
        List<Offset> together = steep.stream()
                .filter(offset -> offset.spread <= LARGEST_JUMP_SPREAD * spread)
                .filter(offset -> Math.abs(offset.mean - offset.median) <= ALIKE * offset.size())
                .toList();
        boolean returns = together.stream().anyMatch(jump -> steep.stream().anyMatch(other -> isReturn(jump, other)));
        boolean block = steep.size() == 2 && isBlock(together);
        return returns && !block ? List.of() : together;
    }

    private boolean isBlock(List<Offset> jumps) {
        return jumps.size() == 2 && isReturn(jumps.get(0), jumps.get(1));
    }

    private boolean isReturn(Offset jump, Offset other) {
        return Math.abs(jump.step + other.step) <= ALIKE * jump.size();
    }

    private static boolean areIndependent(double[] offsets) {
        double square = correlation(offsets, 0);
        return square > 0
                && correlation(offsets, 1) <= LARGEST_WITH_NEXT * square
                && IntStream.rangeClosed(2, offsets.length / 4)
                        .allMatch(lag -> correlation(offsets, lag) <= LARGEST_BEYOND * square);
    }

    private static double correlation(double[] values, int lag) {
        double sum = 0;
        for (int i = 0; i + lag < values.length; i++) {
            sum += values[i] * values[i + lag];
        }
        return sum;
    }

    /** Finds rows without a measurement: missing, constant, or like the row before; if there are many, all count as measured. */
    private static final class MeasuredRows {
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
            BitSet constant = new BitSet();
            BitSet repeated = new BitSet();
            for (int row = 0; row < scan.rows(); row++) {
                unmeasured.set(row, isMissing(row));
                constant.set(row, isConstant(row, -1, 0));
                repeated.set(row, row > 0 && isConstant(row, row - 1, slack));
            }
            if (areOthersNoisy(constant, repeated, slack)) {
                unmeasured.or(constant);
                // A single row that equals the one before may be the crest of a symmetric surface.
                runs(repeated).stream()
                        .filter(run -> run[1] - run[0] > 1)
                        .forEach(run -> unmeasured.set(run[0], run[1]));
            }
            if (runs(unmeasured).size() * ROWS_PER_RUN > scan.rows() - unmeasured.cardinality()) {
                unmeasured.clear();
            }
        }

        /**
         * True if most samples of the other rows differ from those before by more than the rows' offset: rows of a computed surface that is
         * constant along x or y differ at defects alone.
         */
        private boolean areOthersNoisy(BitSet constant, BitSet repeated, double slack) {
            long[] alike = new long[2];
            for (int row = 1; row < scan.rows(); row++) {
                if (!constant.get(row)
                        && !repeated.get(row)
                        && unmeasured.get(row - 1, row + 1).isEmpty()) {
                    double[] differences = differences(scan, row - 1);
                    double offset = median(Arrays.stream(differences));
                    alike[0] += Arrays.stream(differences)
                            .filter(difference -> Math.abs(difference - offset) <= slack)
                            .count();
                    alike[1] += differences.length;
                }
            }
            return 2 * alike[0] < alike[1];
        }

        private boolean isMissing(int row) {
            long missing = IntStream.range(0, scan.columns())
                    .filter(column -> !Double.isFinite(scan.at(column, row)))
                    .count();
            return missing >= MISSING * scan.columns();
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

        /** Describes the rows without a measurement and the largest part without them; the place is that of the examined samples. */
        Optional<ScanFault> fault(HeightMap whole, Crop.Samples place) {
            if (unmeasured.isEmpty()) {
                return Optional.empty();
            }
            BitSet measured = (BitSet) unmeasured.clone();
            measured.flip(0, scan.rows());
            Optional<Crop> part = runs(measured).stream()
                    .max(Comparator.comparingInt(run -> run[1] - run[0]))
                    .map(run -> place.rows(run[0], run[1]).area(whole));
            int count = unmeasured.cardinality();
            String words = (count == 1 ? "row " : "rows ") + numbers(place.firstRow() + 1) + " of " + whole.rows()
                    + " (from the top) hold no measurement: missing, constant, or equal to the row above";
            return Optional.of(new ScanFault(
                    words, part, Optional.empty(), unmeasured.stream().boxed().toList(), ""));
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
}
