package sunbeam.precompute.fault;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Finds rows of a scan that were not measured, and rows that lie higher or lower as a whole than their neighbors. The offset of a row
 * against the one before is the median over the columns of the difference; how far columns stray from it (1.4826 times the median
 * distance) says what the surface does by itself. A surface with lines along the rows has offsets, too, but smoothly, at equal distances, or
 * up and down again.
 */
public final class ScanFaults {
    private static final int FEWEST_ROWS = 16;
    private static final int FEWEST_COLUMNS = 16;
    // Columns that are looked at, evenly spread: a median of so many is known to a twelfth of what they stray by.
    private static final int MOST_COLUMNS = 256;
    // Of a Gaussian's deviation over its median distance from the middle.
    private static final double GAUSSIAN = 1.4826;
    // A jump, in deviations of all offsets, and over what columns stray by.
    private static final double STANDING_OUT = 10;
    private static final double ABOVE_SPREAD = 4;
    // In a jump columns stray no more than so many times as elsewhere, and their mean is their median.
    private static final double TOGETHER = 3;
    private static final double ALIKE = 0.25;
    private static final int MOST_JUMPS = 3;
    // Offsets of all rows, over what columns stray by: less is chance.
    private static final double LEAST_OFFSET = 0.5;
    // Correlation of neighboring offsets: -0.5 where each row has one of its own, 0 for a walk, near 1 for a smooth
    // surface.
    private static final double LARGEST_WITH_NEXT = 0.3;
    // With farther ones: near 1 for a grating, up to three deviations by chance.
    private static final double LARGEST_BEYOND = 0.35;

    private final HeightMap whole;
    private final Crop.Samples place;
    private final List<Offset> offsets;
    private final double spread;
    private final double middle;
    private final double deviation;

    /**
     * Of a row against the one before.
     *
     * @param row the upper of both, in the part that counts
     * @param median over the columns, metres
     * @param mean over the columns, metres
     * @param spread robust deviation over the columns, metres
     */
    private record Offset(int row, double median, double mean, double spread) {}

    private ScanFaults(HeightMap whole, Crop.Samples place, HeightMap scan, MeasuredRows measured) {
        this.whole = whole;
        this.place = place;
        this.offsets = IntStream.range(0, scan.rows())
                .parallel()
                .filter(measured::isPair)
                .mapToObj(row -> offset(scan, row))
                .filter(offset -> Double.isFinite(offset.median))
                .toList();
        this.spread = median(offsets.stream().mapToDouble(Offset::spread));
        this.middle = median(offsets.stream().mapToDouble(Offset::median));
        this.deviation = GAUSSIAN * median(offsets.stream().mapToDouble(offset -> Math.abs(offset.median - middle)));
    }

    /**
     * The faults of a scan, those that leave the least of it first.
     *
     * @param whole heights as they were measured, with their tilt, before anything is filled
     * @param crop the part that counts; all without it
     * @throws IllegalArgumentException when the crop does not suit the scan
     */
    public static List<ScanFault> in(HeightMap whole, Optional<Crop> crop) {
        Crop.Samples place = crop.map(part -> part.samples(whole)).orElseGet(() -> Crop.Samples.allOf(whole));
        HeightMap scan = crop.isPresent() ? crop.get().apply(whole) : whole;
        if (scan.rows() < FEWEST_ROWS || scan.columns() < FEWEST_COLUMNS) {
            return List.of();
        }
        MeasuredRows measured = new MeasuredRows(scan);
        List<ScanFault> faults = new ArrayList<>();
        measured.fault(whole, place).ifPresent(faults::add);
        faults.addAll(new ScanFaults(whole, place, scan, measured).offsets());
        return faults;
    }

    private static Offset offset(HeightMap scan, int row) {
        int stride = (scan.columns() + MOST_COLUMNS - 1) / MOST_COLUMNS;
        double[] heights = scan.heights();
        double[] differences = IntStream.range(0, scan.columns() / stride)
                .map(i -> row * scan.columns() + i * stride)
                .mapToDouble(i -> heights[i + scan.columns()] - heights[i])
                .filter(Double::isFinite)
                .toArray();
        double median = median(Arrays.stream(differences));
        double mean = Arrays.stream(differences).average().orElse(Double.NaN);
        double spread = GAUSSIAN * median(Arrays.stream(differences).map(difference -> Math.abs(difference - median)));
        return new Offset(row, median, mean, spread);
    }

    /** NaN of none. */
    private static double median(DoubleStream values) {
        return StatUtils.percentile(values.toArray(), 50);
    }

    private List<ScanFault> offsets() {
        if (offsets.size() < FEWEST_ROWS || !(spread > 0)) {
            return List.of();
        }
        List<ScanFault> faults = new ArrayList<>();
        List<Offset> jumps = jumps();
        for (Offset jump : jumps) {
            faults.add(levelled(Text.format(
                    "all heights jump by %s between rows %d and %d of %d (from the top)",
                    Lengths.rounded(Math.abs(jump.median), 2),
                    place.firstRow() + jump.row + 1,
                    place.firstRow() + jump.row + 2,
                    whole.rows())));
        }
        double[] others = offsets.stream()
                .filter(offset -> !jumps.contains(offset))
                .mapToDouble(offset -> Math.max(-3 * deviation, Math.min(3 * deviation, offset.median - middle)))
                .toArray();
        if (deviation >= LEAST_OFFSET * spread && areIndependent(others)) {
            faults.add(levelled(Text.format(
                    "rows lie higher or lower than their neighbors by %s rms, each by itself",
                    Lengths.rounded(deviation, 2))));
        }
        return faults;
    }

    private static ScanFault levelled(String words) {
        return new ScanFault(words, Optional.empty(), Optional.of(Levelling.MEDIAN_ROWS), 0, "");
    }

    /** A few that the surface does not make: none where it goes up and down again by as much, as a ridge along the rows does. */
    private List<Offset> jumps() {
        double least = Math.max(STANDING_OUT * deviation, ABOVE_SPREAD * spread);
        List<Offset> steep = offsets.stream()
                .filter(offset -> Math.abs(offset.median - middle) > least)
                .toList();
        List<Offset> together = steep.stream()
                .filter(offset -> offset.spread <= TOGETHER * spread)
                .filter(offset -> Math.abs(offset.mean - offset.median) <= ALIKE * Math.abs(offset.median))
                .toList();
        boolean returns = together.stream()
                .anyMatch(jump -> steep.stream()
                        .anyMatch(other -> Math.abs(jump.median + other.median - 2 * middle)
                                <= ALIKE * Math.abs(jump.median - middle)));
        return returns || together.size() > MOST_JUMPS ? List.of() : together;
    }

    private static boolean areIndependent(double[] offsets) {
        double square = correlation(offsets, 0);
        if (!(square > 0) || correlation(offsets, 1) > LARGEST_WITH_NEXT * square) {
            return false;
        }
        return IntStream.rangeClosed(2, offsets.length / 4)
                .allMatch(lag -> correlation(offsets, lag) <= LARGEST_BEYOND * square);
    }

    private static double correlation(double[] values, int lag) {
        double sum = 0;
        for (int i = 0; i + lag < values.length; i++) {
            sum += values[i] * values[i + lag];
        }
        return sum;
    }
}
