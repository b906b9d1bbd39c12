package sunbeam.precompute.prepare;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * Isolated samples far above or below their surroundings, from dust or a slipping tip, and the heights with medians in their place. A spike
 * differs from the median of its 5 x 5 neighborhood by more than eight robust deviations (1.4826 times the median of all such differences).
 * Fewer than a quarter of that neighborhood differ from the median, to the same side, by more than half as much; at the corner of a line,
 * which must stay, a third do. The largest difference is in meters.
 */
public record Spikes(HeightMap cleaned, int count, double largest) {
    // Ratio of the relief to the range of nearly all heights, and to the relief without spikes; for noise about 2.
    private static final double CONSPICUOUS = 2.5;
    // Without the highest and the lowest 0.5 %.
    private static final double NEARLY_ALL = 0.995;
    private static final int MOST_EXAMINED = 100_000;
    private static final double DEVIATIONS = 8;
    // Ratio of a Gaussian's standard deviation to its median absolute deviation.
    static final double GAUSSIAN = 1.4826;
    private static final double ISOLATED = 0.25;
    private static final int REACH = 2;

    /** Returns the spikes of leveled heights if they account for most of the relief. */
    public static Optional<Spikes> conspicuous(HeightMap field) {
        double relief = field.relief();
        if (!(relief > CONSPICUOUS * usualRange(field.heights()))) {
            return Optional.empty();
        }
        return Optional.of(remove(field))
                .filter(spikes -> spikes.count() > 0 && relief > CONSPICUOUS * spikes.cleaned.relief());
    }

    private static double usualRange(double[] heights) {
        int stride = Math.max(1, heights.length / MOST_EXAMINED);
        double[] some = IntStream.range(0, heights.length / stride)
                .mapToDouble(i -> heights[i * stride])
                .filter(Double::isFinite)
                .sorted()
                .toArray();
        int outside = (int) ((1 - NEARLY_ALL) * some.length);
        return some.length == 0 ? Double.NaN : some[some.length - 1 - outside] - some[outside];
    }

    static Spikes remove(HeightMap field) {
        double[] medians = new double[field.heights().length];
        IntStream.range(0, field.rows()).parallel().forEach(row -> {
            double[] around = new double[(2 * REACH + 1) * (2 * REACH + 1)];
            for (int i = row * field.columns(); i < (row + 1) * field.columns(); i++) {
                medians[i] = median(field, i, around);
            }
        });
        double limit = DEVIATIONS * GAUSSIAN * medianDifference(field.heights(), medians);
        double[] heights = field.heights().clone();
        double[] around = new double[(2 * REACH + 1) * (2 * REACH + 1)];
        int count = 0;
        double largest = 0;
        for (int i = 0; i < heights.length; i++) {
            double difference = field.heights()[i] - medians[i];
            if (Math.abs(difference) > limit && isIsolated(field, i, medians[i], difference, around)) {
                heights[i] = medians[i];
                count++;
                largest = Math.max(largest, Math.abs(difference));
            }
        }
        return new Spikes(field.with(heights), count, largest);
    }

    private static double median(HeightMap field, int index, double[] around) {
        int count = gather(field, index % field.columns(), index / field.columns(), around);
        Arrays.sort(around, 0, count);
        return count == 0 ? Double.NaN : around[count / 2];
    }

    private static int gather(HeightMap field, int column, int row, double[] around) {
        int count = 0;
        for (int r = Math.max(0, row - REACH); r <= Math.min(field.rows() - 1, row + REACH); r++) {
            for (int c = Math.max(0, column - REACH); c <= Math.min(field.columns() - 1, column + REACH); c++) {
                double height = field.at(c, r);
                if (Double.isFinite(height)) {
                    around[count++] = height;
                }
            }
        }
        return count;
    }

    private static boolean isIsolated(HeightMap field, int index, double median, double difference, double[] around) {
        int count = gather(field, index % field.columns(), index / field.columns(), around);
        int companions = 0;
        for (int i = 0; i < count; i++) {
            companions += (around[i] - median) / difference > 0.5 ? 1 : 0;
        }
        return companions < ISOLATED * count;
    }

    /** Ignores differences of 0, which most are on a coarsely quantized, smooth surface. */
    private static double medianDifference(double[] heights, double[] medians) {
        double[] differences = IntStream.range(0, medians.length)
                .mapToDouble(i -> Math.abs(heights[i] - medians[i]))
                .filter(difference -> difference > 0 && Double.isFinite(difference))
                .sorted()
                .toArray();
        return differences.length == 0 ? 0 : differences[differences.length / 2];
    }
}
