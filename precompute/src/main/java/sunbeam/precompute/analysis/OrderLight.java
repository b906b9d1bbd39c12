package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderSpectrum.Wave;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;
import sunbeam.precompute.spectrum.ComplexVector;

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
            if (parts.length < 2) {
                return new Efficiency(power, Double.NaN, Double.NaN);
            }
            double half = GratingPeriod.student(parts.length - 1) * Math.sqrt(StatUtils.variance(parts) / parts.length);
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
}
