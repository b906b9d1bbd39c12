package sunbeam.precompute.prepare;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * Spikes: isolated samples far above or below their surroundings, from dust or a slipping tip. A spike differs from the median of its 5 x 5
 * neighborhood by more than eight robust deviations (1.4826 times the median of all such differences), and fewer than a quarter of that
 * neighborhood differ from the median, to the same side, by more than half as much. At the corner of a line, which must stay, a third do.
 *
 * @param cleaned heights with the medians in place of spikes
 * @param count number of replaced samples
 * @param largest largest difference between a spike and its median, in meters
 */
public record Spikes(HeightMap cleaned, int count, double largest) {
    // Least ratio of the relief to the range of nearly all heights, and also to the relief without spikes; for mere
    // noise the first ratio is about 2.
    private static final double CONSPICUOUS = 2.5;
    // Share of the heights, after as many of the highest as of the lowest were left out: 0.5 % each.
    private static final double NEARLY_ALL = 0.995;
    private static final int MOST_EXAMINED = 100_000;
    private static final double DEVIATIONS = 8;
    private static final double GAUSSIAN = 1.4826;
    private static final double ISOLATED = 0.25;
    // Samples from the center of the 5 x 5 neighborhood to its border.
    private static final int REACH = 2;

    /**
     * Returns the spikes of a scan if they account for most of its relief; else empty.
     *
     * @param field leveled heights
     */
    public static Optional<Spikes> conspicuous(HeightMap field) {
        double relief = field.relief();
        if (!(relief > CONSPICUOUS * usualRange(field.heights()))) {
            return Optional.empty();
        }
        return Optional.of(remove(field))
                .filter(spikes -> spikes.count() > 0 && relief > CONSPICUOUS * spikes.cleaned.relief());
    }

    /** Returns the range of nearly all heights, in meters, estimated from an evenly spaced subset. */
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

    /** Replaces all spikes of leveled heights by the medians of their neighborhoods. */
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

    /** Returns the median of the samples around an index, without missing ones; NaN if all are missing. */
    private static double median(HeightMap field, int index, double[] around) {
        int count = gather(field, index % field.columns(), index / field.columns(), around);
        Arrays.sort(around, 0, count);
        return count == 0 ? Double.NaN : around[count / 2];
    }

    /** Copies the heights of the neighborhood without missing ones to {@code around}, and returns their number. */
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

    /**
     * Returns the median of the samples' absolute differences from their medians, without those of 0: on a coarsely quantized, smooth
     * surface most are 0.
     */
    private static double medianDifference(double[] heights, double[] medians) {
        double[] differences = IntStream.range(0, medians.length)
                .mapToDouble(i -> Math.abs(heights[i] - medians[i]))
                .filter(difference -> difference > 0 && Double.isFinite(difference))
                .sorted()
                .toArray();
        return differences.length == 0 ? 0 : differences[differences.length / 2];
    }
}
