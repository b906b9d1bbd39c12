package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.ArithmeticUtils;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;
import sunbeam.precompute.spectrum.ComplexVector;

/**
 * Reciprocal lattice of orders: (m, n) leaves along wr = -wi + lambda (m first + n second) in the surface's plane.
 *
 * @param second frequency of order (0, 1); empty for a grating
 */
public record OrderLattice(SpatialFrequency first, Optional<SpatialFrequency> second) {
    // Share of the variance in a frequency of the lattice: float files round to 1e-7 of the relief.
    private static final double WEAKEST = 1e-9;
    // Least sine of the angle between waves.
    private static final double CROSSING = 0.3;

    public record Order(int m, int n) {
        /** Returns "-1", or "(1, -2)" in a lattice of two frequencies. */
        public String in(OrderLattice lattice) {
            return lattice.second.isPresent() ? "(" + m + ", " + n + ")" : String.valueOf(m);
        }
    }

    /** Lattice of bins, of all sums of some of them: the vectors (a, b) and (0, d) generate it (Hermite normal form). */
    private static final class BinLattice {
        private int a;
        private int b;
        private int d;

        void add(int x, int y) {
            while (x != 0) {
                int times = a / x;
                int nextX = a - times * x;
                int nextY = b - times * y;
                a = x;
                b = y;
                x = nextX;
                y = nextY;
            }
            d = ArithmeticUtils.gcd(d, y);
            b = d > 0 ? Math.floorMod(b, d) : b;
        }

        OrderLattice over(double width, double height) {
            SpatialFrequency slanted = new SpatialFrequency(a / width, b / height);
            SpatialFrequency upright = new SpatialFrequency(0, d / height);
            return a == 0 || d == 0
                    ? new OrderLattice(positive(a == 0 ? upright : slanted), Optional.empty())
                    : reduced(slanted, upright);
        }
    }

    public static OrderLattice of(Patch patch, GratingPeriod period) {
        SpatialFrequency wave = period.wave();
        if (patch.repetition() == Patch.Repetition.PERIODIC) {
            return generated(patch.scan(), false, false).along(wave);
        }
        Stream<SpatialFrequency> crossing = period.others().stream().filter(other -> other.sineTo(wave) > CROSSING);
        return new OrderLattice(positive(wave), crossing.findFirst().map(OrderLattice::positive));
    }

    /**
     * Returns the lattice of a patch that repeats, with the orders by which its samples repeat the spectrum, if some light sees them.
     *
     * @param wavelength shortest one, meters
     */
    public OrderLattice ofSamples(Patch patch, List<Direction> lights, double wavelength) {
        HeightMap map = patch.scan();
        boolean x = lights.stream().anyMatch(wi -> wavelength < map.pitchX() * (1 + Math.abs(wi.x())));
        boolean y = lights.stream().anyMatch(wi -> wavelength < map.pitchY() * (1 + Math.abs(wi.y())));
        return (x || y) && patch.repetition() == Patch.Repetition.PERIODIC
                ? generated(map, x, y).along(first)
                : this;
    }

    private OrderLattice along(SpatialFrequency wave) {
        return second.filter(other -> other.sineTo(wave) < WEAKEST)
                .map(other -> new OrderLattice(other, Optional.of(first)))
                .orElse(this);
    }

    /** Returns the coarsest lattice of all frequencies, and of those of the samples along x or y. */
    private static OrderLattice generated(HeightMap map, boolean samplesX, boolean samplesY) {
        BinLattice lattice = new BinLattice();
        lattice.add(samplesX ? map.columns() : 0, 0);
        lattice.add(0, samplesY ? map.rows() : 0);
        int left = -(map.columns() / 2);
        int bottom = -(map.rows() / 2);
        double mean = StatUtils.mean(map.heights());
        ComplexVector bins = new BandTransform2d(
                        map.columns(), map.rows(), new Band(left, map.columns()), new Band(bottom, map.rows()))
                .transform((row, real, imaginary) -> Arrays.setAll(real, column -> map.at(column, row) - mean));
        double[] power = new double[bins.length()];
        Arrays.setAll(power, i -> Math.pow(bins.real()[i], 2) + Math.pow(bins.imaginary()[i], 2));
        double least = WEAKEST * StatUtils.sum(power);
        for (int i = 0; i < power.length; i++) {
            if (power[i] > least) {
                lattice.add(left + i % map.columns(), bottom + i / map.columns());
            }
        }
        return lattice.over(map.width(), map.height());
    }

    /** Returns the shortest vectors of a lattice (Gauss's reduction). */
    private static OrderLattice reduced(SpatialFrequency one, SpatialFrequency other) {
        SpatialFrequency shorter = one.length() <= other.length() ? one : other;
        SpatialFrequency longer = one.length() <= other.length() ? other : one;
        double times = Math.rint((shorter.x() * longer.x() + shorter.y() * longer.y()) / Math.pow(shorter.length(), 2));
        return times == 0
                ? new OrderLattice(positive(shorter), Optional.of(positive(longer)))
                : reduced(
                        shorter,
                        new SpatialFrequency(longer.x() - times * shorter.x(), longer.y() - times * shorter.y()));
    }

    private static SpatialFrequency positive(SpatialFrequency wave) {
        return wave.x() > 0 || (wave.x() == 0 && wave.y() > 0) ? wave : wave.times(-1);
    }

    /** Returns the nearest order; empty between the orders of a grating. */
    Optional<Order> nearest(SpatialFrequency frequency) {
        SpatialFrequency crossing = second.orElseGet(() -> new SpatialFrequency(-first.y(), first.x()));
        double area = first.x() * crossing.y() - first.y() * crossing.x();
        // Heights h(f) send light to (u, v) = lambda f = -(wi + wr).
        int m = (int) Math.rint(-(frequency.x() * crossing.y() - frequency.y() * crossing.x()) / area);
        int n = (int) Math.rint(-(first.x() * frequency.y() - first.y() * frequency.x()) / area);
        return n != 0 && second.isEmpty() ? Optional.empty() : Optional.of(new Order(m, n));
    }

    /** Cycles per meter; the order leaves along wr = -wi + lambda times this. */
    public SpatialFrequency frequency(Order order) {
        SpatialFrequency alongSecond = second.map(other -> other.times(order.n)).orElse(new SpatialFrequency(0, 0));
        return alongSecond.plus(first.times(order.m));
    }

    /** Returns the largest number of orders above the horizon at a wavelength in meters, one more or less. */
    public double most(double wavelength) {
        double length = wavelength * first.length();
        return second.map(other -> Math.PI / (length * wavelength * other.length() * first.sineTo(other)))
                .orElse(2 / length);
    }

    /** Returns the direction in the patch's frame; empty beyond the horizon. */
    public Optional<Direction> direction(Order order, Direction wi, double wavelength) {
        SpatialFrequency frequency = frequency(order);
        double x = -wi.x() + wavelength * frequency.x();
        double y = -wi.y() + wavelength * frequency.y();
        double cosine = Math.sqrt(1 - x * x - y * y);
        return cosine > OrderSpectrum.GRAZING ? Optional.of(new Direction(x, y, cosine)) : Optional.empty();
    }
}
