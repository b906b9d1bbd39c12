package sunbeam.precompute.analysis;

import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.math3.util.ArithmeticUtils;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;

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

    public static OrderLattice of(Patch patch, GratingPeriod period) {
        SpatialFrequency wave = period.wave();
        if (patch.repetition() == Patch.Repetition.PERIODIC) {
            OrderLattice exact = generated(HeightSpectrum.of(patch.scan(), HeightSpectrum.Edges.PERIODIC));
            return exact.second
                    .filter(other -> other.sineTo(wave) < WEAKEST)
                    .map(other -> new OrderLattice(other, Optional.of(exact.first)))
                    .orElse(exact);
        }
        Stream<SpatialFrequency> crossing = period.others().stream().filter(other -> other.sineTo(wave) > CROSSING);
        return new OrderLattice(positive(wave), crossing.findFirst().map(OrderLattice::positive));
    }

    /** Returns the coarsest lattice of all frequencies. */
    private static OrderLattice generated(HeightSpectrum spectrum) {
        // The vectors (a, b) and (0, d), in bins, generate the lattice (Hermite normal form).
        int a = 0;
        int b = 0;
        int d = 0;
        double[] power = spectrum.power();
        for (int place = power.length / 2 + 1; place < power.length; place++) {
            if (power[place] > WEAKEST * spectrum.total()) {
                int x = spectrum.binX(place);
                int y = spectrum.binY(place);
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
        }
        SpatialFrequency slanted = new SpatialFrequency(a / spectrum.width(), b / spectrum.height());
        SpatialFrequency upright = new SpatialFrequency(0, d / spectrum.height());
        if (a == 0 || d == 0) {
            return new OrderLattice(positive(a == 0 ? upright : slanted), Optional.empty());
        }
        return reduced(slanted, upright);
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
    SpatialFrequency frequency(Order order) {
        double x =
                order.m * first.x() + second.map(other -> order.n * other.x()).orElse(0.0);
        double y =
                order.m * first.y() + second.map(other -> order.n * other.y()).orElse(0.0);
        return new SpatialFrequency(x, y);
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
