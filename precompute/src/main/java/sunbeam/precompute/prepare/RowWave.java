package sunbeam.precompute.prepare;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.optics.HeightMap;

/** Wave in the heights of whole rows, which a leveling of rows removes: lines of a grating along the rows. */
public final class RowWave {
    // Steps between rows that may be faults.
    private static final int MOST_JUMPS = 4;
    private static final int FEWEST_PERIODS = 3;
    private static final int OVERTONES = 3;
    // Bins of a Hann window's line, relative to its peak.
    private static final double HANN_BINS = 1.5;
    // Least share of the steps' power in a wave; probability that the strongest of a few random waves has as much.
    private static final double LEAST_SHARE = 0.3;
    private static final double FALSE_ALARMS = 0.005;

    private RowWave() {}

    /** Returns the period, meters, of a wave in the medians of rows; empty if these are noise. */
    public static OptionalDouble period(HeightMap leveled) {
        double[] medians = IntStream.range(0, leveled.rows())
                .parallel()
                .mapToDouble(row -> median(leveled, row))
                .toArray();
        double[] steps = IntStream.range(1, medians.length)
                .mapToDouble(row -> medians[row] - medians[row - 1])
                .filter(Double::isFinite)
                .toArray();
        if (steps.length < 4 * FEWEST_PERIODS) {
            return OptionalDouble.empty();
        }
        double[] sizes = Arrays.stream(steps).map(Math::abs).sorted().toArray();
        double largest = sizes[sizes.length - 1 - MOST_JUMPS];
        double mean = StatUtils.mean(steps);
        int padded = 2 * Integer.highestOneBit(steps.length);
        double[] tapered = new double[padded];
        for (int i = 0; i < steps.length; i++) {
            double sine = Math.sin(Math.PI * (i + 0.5) / steps.length);
            tapered[i] = sine * sine * (Math.max(-largest, Math.min(largest, steps[i])) - mean);
        }
        Complex[] spectrum =
                new FastFourierTransformer(DftNormalization.STANDARD).transform(tapered, TransformType.FORWARD);
        double[] power = Arrays.stream(spectrum, 0, padded / 2)
                .mapToDouble(bin -> Math.pow(bin.abs(), 2))
                .toArray();
        double padding = (double) padded / steps.length;
        int first = (int) Math.ceil(FEWEST_PERIODS * padding);
        int top = IntStream.range(first, power.length)
                .reduce((one, other) -> power[other] > power[one] ? other : one)
                .orElse(first);
        double line = IntStream.rangeClosed(1, OVERTONES)
                .filter(k -> k * top < power.length)
                .mapToDouble(k -> power[k * top])
                .sum();
        double share = Math.min(1, HANN_BINS * padding * line / StatUtils.sum(power));
        double periods = top / padding;
        boolean isWave = share >= LEAST_SHARE && (periods + 1) * Math.pow(1 - share, periods) <= FALSE_ALARMS;
        return isWave ? OptionalDouble.of(steps.length * leveled.pitchY() / periods) : OptionalDouble.empty();
    }

    private static double median(HeightMap map, int row) {
        double[] known = Arrays.stream(map.heights(), row * map.columns(), (row + 1) * map.columns())
                .filter(Double::isFinite)
                .toArray();
        return StatUtils.percentile(known, 50);
    }
}
