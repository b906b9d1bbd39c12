package sunbeam.precompute.prepare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Edges.Seam;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Lengths;

/** Preparation of a scan, in this order: crop, level, despike, fill missing samples, treat edges. */
public record Preparation(Optional<Crop> crop, Leveling leveling, boolean despike, Edges edges) {
    /**
     * Prepared scan: before and after its edges are treated (light uses the latter), the former with NaN where samples were filled, words for
     * the steps.
     */
    public record Prepared(HeightMap scan, HeightMap surface, HeightMap known, List<String> steps) {}

    /** Prepares heights; throws IllegalArgumentException if all samples are missing, or as {@link Crop#apply}. */
    public Prepared apply(HeightMap measured) {
        List<String> steps = new ArrayList<>();
        HeightMap field = crop.isPresent() ? crop.get().apply(measured) : measured;
        if (crop.isPresent()) {
            steps.add("cropped from " + rounded(measured.width()) + " x " + rounded(measured.height()));
        }
        field = leveling.apply(field);
        steps.add("levelling " + ValueKind.name(leveling));
        if (despike) {
            Spikes spikes = Spikes.remove(field);
            field = spikes.cleaned();
            steps.add(
                    spikes.count() == 0
                            ? "no spikes"
                            : spikes.count() + " spike samples removed, the highest by " + rounded(spikes.largest()));
        }
        int missing = (int) Arrays.stream(field.heights())
                .filter(height -> !Double.isFinite(height))
                .count();
        HeightMap gaps = field;
        if (missing > 0) {
            // Filled samples would bend a fitted plane, so only the mean is subtracted again.
            HeightMap filled = MissingHeights.fill(field);
            field = leveling == Leveling.NONE ? filled : Leveling.MEAN.apply(filled);
            steps.add(missing + " missing samples filled");
        }
        HeightMap known = missing > 0 ? known(field, gaps) : field;
        HeightMap surface = edges.apply(field);
        if (edges == Edges.BLEND) {
            steps.add("edges blended over " + rounded(field.width() - surface.width()) + " x "
                    + rounded(field.height() - surface.height()) + " (a step of "
                    + rounded(Seam.of(field).jump()) + " rms)");
        }
        return new Prepared(field, surface, known, steps);
    }

    private static HeightMap known(HeightMap filled, HeightMap gaps) {
        double[] heights = filled.heights().clone();
        Arrays.setAll(heights, i -> Double.isFinite(gaps.heights()[i]) ? heights[i] : Double.NaN);
        return filled.with(heights);
    }

    private static String rounded(double meters) {
        return Lengths.rounded(meters, 3);
    }

    /**
     * Fills missing samples (NaN or infinite) from their surroundings: ring by ring from the edge of each hole inwards, every sample becomes
     * the average of its known neighbors, eight at most. Linear in the number of samples.
     */
    record MissingHeights(HeightMap map, double[] heights) {
        static HeightMap fill(HeightMap map) {
            if (Arrays.stream(map.heights()).noneMatch(Double::isFinite)) {
                throw new IllegalArgumentException("all " + map.heights().length + " samples are missing");
            }
            MissingHeights filling = new MissingHeights(map, map.heights().clone());
            int[] ring = IntStream.range(0, filling.heights.length)
                    .filter(i -> !Double.isFinite(filling.heights[i]) && filling.neighbors(i, true).length > 0)
                    .toArray();
            while (ring.length > 0) {
                double[] averages =
                        Arrays.stream(ring).mapToDouble(filling::averageOfKnown).toArray();
                for (int i = 0; i < ring.length; i++) {
                    filling.heights[ring[i]] = averages[i];
                }
                ring = Arrays.stream(ring)
                        .flatMap(i -> Arrays.stream(filling.neighbors(i, false)))
                        .distinct()
                        .toArray();
            }
            return map.with(filling.heights);
        }

        private double averageOfKnown(int index) {
            int[] known = neighbors(index, true);
            double first = heights[known[0]];
            // A large offset costs no digits.
            return first
                    + Arrays.stream(known).mapToDouble(i -> heights[i] - first).sum() / known.length;
        }

        private int[] neighbors(int index, boolean known) {
            int row = index / map.columns();
            int column = index % map.columns();
            int[] found = new int[8];
            int length = 0;
            for (int r = Math.max(0, row - 1); r <= Math.min(map.rows() - 1, row + 1); r++) {
                for (int c = Math.max(0, column - 1); c <= Math.min(map.columns() - 1, column + 1); c++) {
                    int neighbor = r * map.columns() + c;
                    if (neighbor != index && Double.isFinite(heights[neighbor]) == known) {
                        found[length++] = neighbor;
                    }
                }
            }
            return Arrays.copyOf(found, length);
        }
    }

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

        /** Returns some evenly spaced heights without missing ones, ascending. */
        public static double[] sorted(double[] heights) {
            int stride = Math.max(1, heights.length / MOST_EXAMINED);
            return IntStream.range(0, heights.length / stride)
                    .mapToDouble(i -> heights[i * stride])
                    .filter(Double::isFinite)
                    .sorted()
                    .toArray();
        }

        private static double usualRange(double[] heights) {
            double[] some = sorted(heights);
            int outside = (int) ((1 - NEARLY_ALL) * some.length);
            return some.length == 0 ? Double.NaN : some[some.length - 1 - outside] - some[outside];
        }

        static Spikes remove(HeightMap field) {
            double[] medians = new double[field.heights().length];
            IntStream.range(0, field.rows()).parallel().forEach(row -> {
                double[] around = new double[(2 * REACH + 1) * (2 * REACH + 1)];
                for (int i = row * field.columns(); i < (row + 1) * field.columns(); i++) {
                    int count = gather(field, i, around);
                    Arrays.sort(around, 0, count);
                    medians[i] = count == 0 ? Double.NaN : around[count / 2];
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

        private static int gather(HeightMap field, int index, double[] around) {
            int column = index % field.columns();
            int row = index / field.columns();
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

        private static boolean isIsolated(
                HeightMap field, int index, double median, double difference, double[] around) {
            int count = gather(field, index, around);
            long companions = Arrays.stream(around, 0, count)
                    .filter(height -> (height - median) / difference > 0.5)
                    .count();
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
}
