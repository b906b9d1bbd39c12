package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;

/**
 * How far a point of a smoothed power spectrum stands above what lies around it. Spectra of surfaces fall steeply with
 * frequency and differ between directions, so the background is the larger of two: the power law through the spectrum
 * in the same direction below and above the point, and the median over all directions at the same frequency.
 */
final class LocalBackground {
    // Where the two sides lie, in units of the point's frequency: clear of the peak, short of its first overtone's far
    // side.
    private static final double LOWER_FROM = 0.4;
    private static final double LOWER_TO = 0.8;
    private static final double UPPER_FROM = 1.25;
    private static final double UPPER_TO = 2.5;
    private static final int SAMPLES = 24;
    private static final int FEWEST = 4;
    // Bins next to 0 hold what levelling and the window have left of the zeroth.
    private static final double LOWEST_BIN = 2.5;
    private static final double RINGS_PER_OCTAVE = 6;
    // Relative to the largest value: below it lies what the window's and the average's tails leave of large peaks.
    private static final double FLOOR = 1e-6;
    private final HeightSpectrum smoothed;
    private final double floor;
    private final double[] ringMedians;

    LocalBackground(HeightSpectrum smoothed) {
        this.smoothed = smoothed;
        this.floor = FLOOR * Arrays.stream(smoothed.power()).max().orElse(0);
        boolean oneAxis = smoothed.bandX().count() == 1 || smoothed.bandY().count() == 1;
        this.ringMedians = oneAxis ? new double[0] : ringMedians();
    }

    /** Power over background; 0 where there is nothing to compare with. */
    double figure(double frequencyX, double frequencyY) {
        return figure(frequencyX, frequencyY, scale -> smoothed.interpolated(frequencyX * scale, frequencyY * scale));
    }

    /** As {@link #figure(double, double)}, with the power along the direction given: 1 is the point itself. */
    double figure(double frequencyX, double frequencyY, DoubleUnaryOperator powerAtScale) {
        double[] lower = logarithms(frequencyX, frequencyY, LOWER_FROM, LOWER_TO, powerAtScale);
        double[] upper = logarithms(frequencyX, frequencyY, UPPER_FROM, UPPER_TO, powerAtScale);
        double power = powerAtScale.applyAsDouble(1);
        if (power <= floor || (lower.length < FEWEST && upper.length < FEWEST)) {
            return 0;
        }
        double ring = Math.log(Math.max(floor, ringMedian(Math.hypot(frequencyX, frequencyY))));
        return Math.exp(Math.log(power) - Math.max(ring, background(lower, upper)));
    }

    /** Logarithms of the spectrum in the point's direction, at equal ratios of frequency. */
    private double[] logarithms(
            double frequencyX, double frequencyY, double from, double to, DoubleUnaryOperator powerAtScale) {
        double[] values = new double[SAMPLES];
        int count = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double scale = from * Math.pow(to / from, i / (SAMPLES - 1.0));
            double x = frequencyX * scale * smoothed.width();
            double y = frequencyY * scale * smoothed.height();
            boolean inside = Math.abs(x) <= smoothed.bandX().last()
                    && Math.abs(y) <= smoothed.bandY().last();
            if (inside && Math.hypot(x, y) >= LOWEST_BIN) {
                values[count++] = Math.log(Math.max(floor, powerAtScale.applyAsDouble(scale)));
            }
        }
        return Arrays.copyOf(values, count);
    }

    /** The power law through the medians of both sides, at the point. */
    private static double background(double[] lower, double[] upper) {
        if (lower.length < FEWEST || upper.length < FEWEST) {
            return median(lower.length < FEWEST ? upper : lower);
        }
        double below = 0.5 * Math.log(LOWER_FROM * LOWER_TO);
        double above = 0.5 * Math.log(UPPER_FROM * UPPER_TO);
        return (median(lower) * above - median(upper) * below) / (above - below);
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
    }

    private double ringMedian(double frequency) {
        return ringMedians.length == 0 ? 0 : ringMedians[ring(frequency)];
    }

    private int ring(double frequency) {
        double lowest = Math.min(1 / smoothed.width(), 1 / smoothed.height());
        return (int) Math.max(0, Math.round(RINGS_PER_OCTAVE * Math.log(frequency / lowest) / Math.log(2)));
    }

    private double[] ringMedians() {
        double corner = Math.hypot(
                smoothed.bandX().last() / smoothed.width(), smoothed.bandY().last() / smoothed.height());
        int[] counts = new int[ring(corner) + 2];
        forEachBin((ring, power) -> counts[ring]++);
        double[][] members = new double[counts.length][];
        Arrays.setAll(members, ring -> new double[counts[ring]]);
        forEachBin((ring, power) -> members[ring][--counts[ring]] = power);
        return Arrays.stream(members)
                .mapToDouble(ring -> ring.length == 0 ? 0 : median(ring))
                .toArray();
    }

    @FunctionalInterface
    private interface BinVisitor {
        void visit(int ring, double power);
    }

    /** Of one half of the plane, which the other mirrors. */
    private void forEachBin(BinVisitor visitor) {
        for (int jy = 0; jy <= smoothed.bandY().last(); jy++) {
            double y = jy / smoothed.height();
            for (int jx = jy == 0 ? 1 : smoothed.bandX().first();
                    jx <= smoothed.bandX().last();
                    jx++) {
                double x = jx / smoothed.width();
                visitor.visit(ring(Math.sqrt(x * x + y * y)), smoothed.at(jx, jy));
            }
        }
    }
}
