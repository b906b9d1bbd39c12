package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.ArithmeticUtils;
import sunbeam.precompute.analysis.OrderLight.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderSpectrum.Wave;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;
import sunbeam.precompute.spectrum.BandTransform2d.ComplexVector;

/**
 * Efficiencies, shares of the incident light, of a surface's orders under one light: of a piece of a surface, the integral around each order,
 * over half the distance to the next.
 *
 * @param wi direction to the light, in the patch's frame
 * @param wavelength meters
 * @param efficiencies of the orders above the horizon
 * @param between share that leaves between the orders of a grating
 * @param sum share that leaves the surface
 * @param mirror share that a flat mirror of the material reflects
 */
public record OrderLight(
        OrderLattice lattice,
        Direction wi,
        double wavelength,
        Map<Order, Efficiency> efficiencies,
        double between,
        double sum,
        double mirror) {
    // Parts of a scan along each axis, whose differences give the interval.
    private static final int PARTS = 4;

    /** Efficiency of an order with the 95 % interval of its mean: NaN from fewer than two parts, the value twice if the surface repeats. */
    public record Efficiency(double value, double low, double high) {
        static final Efficiency NONE = new Efficiency(0, 0, 0);
    }

    private static final class Field {
        private final List<Wave> bins = new ArrayList<>();
        private double power;

        void add(Wave wave, boolean kept) {
            power += wave.power();
            if (kept) {
                bins.add(wave);
            }
        }

        /** Returns the mean powers of up to 4 x 4 parts of the scan; their mean is the power (Parseval). */
        double[] parts() {
            int left = bins.stream().mapToInt(Wave::x).min().orElse(0);
            int bottom = bins.stream().mapToInt(Wave::y).min().orElse(0);
            int columns = bins.stream().mapToInt(Wave::x).max().orElse(0) - left + 1;
            int rows = bins.stream().mapToInt(Wave::y).max().orElse(0) - bottom + 1;
            double[][] real = new double[rows][columns];
            double[][] imaginary = new double[rows][columns];
            for (Wave bin : bins) {
                real[bin.y() - bottom][bin.x() - left] = bin.real();
                imaginary[bin.y() - bottom][bin.x() - left] = bin.imaginary();
            }
            ComplexVector field = new BandTransform2d(columns, rows, Band.of(0, columns - 1), Band.of(0, rows - 1))
                    .transform((row, re, im) -> {
                        System.arraycopy(real[row], 0, re, 0, columns);
                        System.arraycopy(imaginary[row], 0, im, 0, columns);
                    });
            int partsX = Math.min(PARTS, columns);
            int partsY = Math.min(PARTS, rows);
            double[] sums = new double[partsX * partsY];
            double[] counts = new double[sums.length];
            for (int i = 0; i < field.length(); i++) {
                int part = i / columns * partsY / rows * partsX + i % columns * partsX / columns;
                sums[part] += Math.pow(field.real()[i], 2) + Math.pow(field.imaginary()[i], 2);
                counts[part] += 1.0 / (columns * rows) / (columns * rows);
            }
            Arrays.setAll(sums, part -> sums[part] / counts[part]);
            return sums;
        }

        Efficiency efficiency(boolean sampled) {
            if (!sampled) {
                return new Efficiency(power, power, power);
            }
            double[] parts = parts();
            double half = parts.length < 2
                    ? Double.NaN
                    : GratingPeriod.student(parts.length - 1) * Math.sqrt(StatUtils.variance(parts) / parts.length);
            return new Efficiency(power, Math.max(0, power - half), power + half);
        }
    }

    /**
     * Returns the light of orders under a direction in the patch's frame at a wavelength of 380..780 nm, in meters; efficiencies of a sampled
     * scan have an interval.
     */
    public static OrderLight of(
            OrderSpectrum spectrum,
            OrderLattice lattice,
            RefractiveIndex index,
            Direction wi,
            double wavelength,
            boolean sampled) {
        Map<Order, Field> fields = new HashMap<>();
        Field rest = new Field();
        double normal = index.reflectance(wavelength);
        spectrum.forEach(wi, wavelength, sampled, wave -> {
            double fresnel =
                    Math.sqrt(RefractiveIndex.schlick(normal, wave.pair().cosThetaD()));
            lattice.nearest(spectrum.frequency(wave.x(), wave.y()))
                    .map(order -> fields.computeIfAbsent(order, none -> new Field()))
                    .orElse(rest)
                    .add(wave.times(fresnel), sampled);
        });
        Map<Order, Efficiency> efficiencies = new HashMap<>();
        fields.forEach((order, field) -> {
            if (lattice.direction(order, wi, wavelength).isPresent()) {
                efficiencies.put(order, field.efficiency(sampled));
            } else {
                rest.power += field.power;
            }
        });
        double sum =
                efficiencies.values().stream().mapToDouble(Efficiency::value).sum() + rest.power;
        double mirror = index.reflectance(wavelength, wi.z());
        return new OrderLight(lattice, wi, wavelength, efficiencies, rest.power, sum, mirror);
    }

    public Optional<Direction> direction(Order order) {
        return lattice.direction(order, wi, wavelength);
    }

    /** Returns 0 if all the order's light is beyond the horizon. */
    public Efficiency at(Order order) {
        return efficiencies.getOrDefault(order, Efficiency.NONE);
    }

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
            double times =
                    Math.rint((shorter.x() * longer.x() + shorter.y() * longer.y()) / Math.pow(shorter.length(), 2));
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
            SpatialFrequency alongSecond =
                    second.map(other -> other.times(order.n)).orElse(new SpatialFrequency(0, 0));
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
}
