package sunbeam.precompute.analysis;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.RefractiveIndex;

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
    /**
     * Efficiency of an order with the 95 % interval of its mean: NaN from a single bin, the value twice if the surface repeats.
     *
     * @param beside light within the value that lines beside the order send: waves that are no multiples of the period
     */
    public record Efficiency(double value, double low, double high, double beside) {
        static final Efficiency NONE = exact(0);

        static Efficiency exact(double value) {
            return new Efficiency(value, value, value, 0);
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
        Map<Order, OrderField> fields = new HashMap<>();
        OrderField rest = new OrderField();
        double normal = index.reflectance(wavelength);
        spectrum.forEach(wi, wavelength, sampled, wave -> {
            double fresnel =
                    Math.sqrt(RefractiveIndex.schlick(normal, wave.pair().cosThetaD()));
            lattice.nearest(spectrum.frequency(wave.x(), wave.y()))
                    .map(order -> fields.computeIfAbsent(order, none -> new OrderField()))
                    .orElse(rest)
                    .add(wave.times(fresnel), sampled);
        });
        Map<Order, Efficiency> efficiencies = new HashMap<>();
        double between = rest.power();
        for (Map.Entry<Order, OrderField> entry : fields.entrySet()) {
            Order order = entry.getKey();
            OrderField field = entry.getValue();
            if (lattice.direction(order, wi, wavelength).isEmpty()) {
                between += field.power();
            } else if (sampled) {
                efficiencies.put(
                        order,
                        field.estimate(spectrum.bin(lattice.frequency(order).times(-1))));
            } else {
                efficiencies.put(order, Efficiency.exact(field.power()));
            }
        }
        double sum =
                efficiencies.values().stream().mapToDouble(Efficiency::value).sum() + between;
        double mirror = index.reflectance(wavelength, wi.z());
        return new OrderLight(lattice, wi, wavelength, efficiencies, between, sum, mirror);
    }

    public Optional<Direction> direction(Order order) {
        return lattice.direction(order, wi, wavelength);
    }

    /** Returns 0 if all the order's light is beyond the horizon. */
    public Efficiency at(Order order) {
        return efficiencies.getOrDefault(order, Efficiency.NONE);
    }
}
