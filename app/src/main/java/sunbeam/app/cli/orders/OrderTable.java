package sunbeam.app.cli.orders;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.cli.report.ReportFields;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.OrderLattice;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderLight;
import sunbeam.precompute.analysis.OrderLight.Efficiency;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Efficiencies of a surface's orders over wavelength and angle of incidence (docs/evaluation.md).
 *
 * @param phi azimuth of the light, degrees
 * @param nanometers wavelengths, ascending
 * @param incidences one for each angle of the light to the normal
 * @param cie light and observer for the orders' colors
 */
record OrderTable(
        Patch patch,
        GratingPeriod period,
        OrderLattice lattice,
        double phi,
        double[] nanometers,
        List<Incidence> incidences,
        CieTable cie) {
    private static final double NANOMETERS_PER_METER = 1e9;
    // Light near the horizon, whose bins are all beyond it.
    private static final Efficiency DARK = new Efficiency(0, 0, 0);
    private static final Efficiency NONE = new Efficiency(Double.NaN, Double.NaN, Double.NaN);
    /** Number of orders in the report and in the plot. */
    static final int STRONGEST = 6;
    // Largest number of orders beyond the horizon in the report.
    private static final int NAMED = 12;
    private static final int DIGITS = 4;
    // Luminance, 1 for white, of an order's color on the screen: that of pure red, the darkest bright color but blue.
    private static final double LUMINANCE = 0.2;

    /**
     * Orders under one direction of light.
     *
     * @param theta angle of the light to the normal, degrees
     * @param lights orders at each wavelength
     */
    record Incidence(double theta, Direction wi, List<OrderLight> lights) {
        /** Returns all orders that are above the horizon at some wavelength, ascending. */
        List<Order> orders() {
            return lights.stream()
                    .flatMap(light -> light.efficiencies().keySet().stream())
                    .distinct()
                    .sorted(Comparator.comparingInt(Order::n).thenComparingInt(Order::m))
                    .toList();
        }

        double[] all(ToDoubleFunction<OrderLight> value) {
            return lights.stream().mapToDouble(value).toArray();
        }
    }

    /** Returns an order's efficiency at a wavelength, given by its index; NaN beyond the horizon. */
    Efficiency at(Incidence incidence, Order order, int wavelength) {
        return direction(incidence, order, wavelength)
                .map(wr -> incidence.lights.get(wavelength).efficiencies().getOrDefault(order, DARK))
                .orElse(NONE);
    }

    /** Returns a number of an order's efficiency at each wavelength, NaN where the order is beyond the horizon. */
    double[] values(Incidence incidence, Order order, ToDoubleFunction<Efficiency> value) {
        return IntStream.range(0, nanometers.length)
                .mapToDouble(i -> value.applyAsDouble(at(incidence, order, i)))
                .toArray();
    }

    /** Returns the orders with the most light over all wavelengths, the strongest first. */
    List<Order> strongest(Incidence incidence) {
        return incidence.orders().stream()
                .sorted(Comparator.comparingDouble(order -> -Arrays.stream(values(incidence, order, Efficiency::value))
                        .filter(Double::isFinite)
                        .sum()))
                .limit(STRONGEST)
                .toList();
    }

    Verdict verdict() {
        return Verdict.of(patch, period);
    }

    Optional<Direction> direction(Incidence incidence, Order order, int wavelength) {
        return lattice.direction(order, incidence.wi, nanometers[wavelength] / NANOMETERS_PER_METER);
    }

    /** Returns the report's lines: the strongest orders under the first light at the middle wavelength. */
    List<String> lines() {
        Incidence incidence = incidences.get(0);
        int middle = nanometers.length / 2;
        OrderLight light = incidence.lights.get(middle);
        List<String> lines = new ArrayList<>();
        lines.add(Text.format(
                "light at %s degrees, azimuth %s degrees, %s nm: %.5f of it leaves, %.5f between the orders; a flat mirror sends %.5f",
                written(incidence.theta),
                written(phi),
                written(nanometers[middle]),
                light.sum(),
                light.between(),
                light.mirror()));
        for (Order order : strongest(incidence)) {
            Efficiency efficiency = at(incidence, order, middle);
            String interval = efficiency.low() == efficiency.value()
                    ? ""
                    : Text.format(" (%.5f to %.5f)", efficiency.low(), efficiency.high());
            lines.add("  order " + order.in(lattice)
                    + direction(incidence, order, middle)
                            .map(wr -> Text.format(
                                    " at theta_r %.1f, phi_r %.1f degrees: %.5f%s, color %s",
                                    theta(wr), phi(wr), efficiency.value(), interval, srgb(xyz(incidence, order))))
                            .orElse(" beyond the horizon"));
        }
        List<String> hidden = incidence.orders().stream()
                .filter(order ->
                        direction(incidence, order, nanometers.length - 1).isEmpty())
                .map(order -> order.in(lattice) + " from " + written(nanometers[visible(incidence, order)]) + " nm")
                .toList();
        if (!hidden.isEmpty()) {
            lines.add("  beyond the horizon: " + String.join(", ", hidden.subList(0, Math.min(NAMED, hidden.size())))
                    + (hidden.size() > NAMED ? ", and " + (hidden.size() - NAMED) + " more (.json)" : ""));
        }
        return lines;
    }

    static String written(double value) {
        return Decimals.rounded(value, DIGITS);
    }

    /** Returns the number of wavelengths at which an order is above the horizon; they are the shortest. */
    private int visible(Incidence incidence, Order order) {
        return (int) IntStream.range(0, nanometers.length)
                .filter(i -> direction(incidence, order, i).isPresent())
                .count();
    }

    private static double theta(Direction direction) {
        return Math.toDegrees(Math.atan2(Math.hypot(direction.x(), direction.y()), direction.z()));
    }

    private static double phi(Direction direction) {
        return Math.toDegrees(Math.atan2(direction.y(), direction.x())) + 0.0;
    }

    /** Returns X, Y, Z of an order's light, relative to the luminance of the incident light of these wavelengths. */
    double[] xyz(Incidence incidence, Order order) {
        double[] sums = new double[4];
        double last = nanometers[nanometers.length - 1];
        for (double at = nanometers[0]; at <= last; at++) {
            double position = nanometers.length == 1 ? 0 : (at - nanometers[0]) / (nanometers[1] - nanometers[0]);
            int below = Math.max(0, Math.min((int) position, nanometers.length - 2));
            int above = Math.min(below + 1, nanometers.length - 1);
            double share = position - below;
            double efficiency =
                    (1 - share) * zeroIfHidden(at(incidence, order, below).value())
                            + share * zeroIfHidden(at(incidence, order, above).value());
            for (int c = 0; c < 3; c++) {
                sums[c] += efficiency * cie.at(at / NANOMETERS_PER_METER, c);
            }
            sums[3] += cie.at(at / NANOMETERS_PER_METER, 1);
        }
        return new double[] {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
    }

    private static double zeroIfHidden(double efficiency) {
        return Double.isNaN(efficiency) ? 0 : efficiency;
    }

    private static String srgb(double... xyz) {
        return Text.format("#%06x", new DisplayTransform(LUMINANCE / xyz[1], Tone.COMPRESS).rgb(xyz));
    }

    /** Returns one row for each order, wavelength and angle of incidence; its directions are columns of {@code reflectance}. */
    AtomicFile.StreamContent csv() {
        List<double[]> rows = new ArrayList<>();
        for (Incidence incidence : incidences) {
            for (Order order : incidence.orders()) {
                for (int i = 0; i < visible(incidence, order); i++) {
                    Direction wr = direction(incidence, order, i).orElseThrow();
                    Efficiency efficiency = at(incidence, order, i);
                    OrderLight light = incidence.lights.get(i);
                    rows.add(new double[] {
                        incidence.theta,
                        phi,
                        theta(wr),
                        phi(wr),
                        nanometers[i],
                        order.m(),
                        order.n(),
                        efficiency.value(),
                        efficiency.low(),
                        efficiency.high(),
                        light.sum(),
                        light.mirror()
                    });
                }
            }
        }
        List<String> names = List.of(
                "theta_i",
                "phi_i",
                "theta_r",
                "phi_r",
                "wavelength",
                "m",
                "n",
                "efficiency",
                "low",
                "high",
                "sum",
                "mirror");
        return CsvWriter.numbers(names, rows.size(), rows::get);
    }

    /** Returns all results by name, for JSON. */
    Map<String, Object> tree() {
        Map<String, Object> tree = ReportFields.of(patch, period, verdict());
        tree.put("program", "Sunbeam " + Version.number());
        tree.put(
                "lattice_per_m",
                Stream.concat(Stream.of(lattice.first()), lattice.second().stream())
                        .map(OrderTable::pair)
                        .toList());
        tree.put("light", cie.description());
        tree.put("wavelengths_m", meters());
        tree.put("incidences", incidences.stream().map(this::tree).toList());
        return tree;
    }

    private double[] meters() {
        return Arrays.stream(nanometers)
                .map(nanometer -> nanometer / NANOMETERS_PER_METER)
                .toArray();
    }

    private static double[] pair(SpatialFrequency frequency) {
        return new double[] {frequency.x(), frequency.y()};
    }

    private Map<String, Object> tree(Incidence incidence) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("theta_i_deg", incidence.theta);
        tree.put("phi_i_deg", phi);
        tree.put("mirror", incidence.all(OrderLight::mirror));
        tree.put("sum", incidence.all(OrderLight::sum));
        tree.put("between_orders", incidence.all(OrderLight::between));
        tree.put(
                "orders",
                incidence.orders().stream().map(order -> tree(incidence, order)).toList());
        return tree;
    }

    private Map<String, Object> tree(Incidence incidence, Order order) {
        int visible = visible(incidence, order);
        List<Direction> directions = IntStream.range(0, visible)
                .mapToObj(i -> direction(incidence, order, i).orElseThrow())
                .toList();
        double[] xyz = xyz(incidence, order);
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("m", order.m());
        tree.put("n", order.n());
        tree.put("beyond_horizon_from_m", visible < nanometers.length ? meters()[visible] : null);
        tree.put("theta_r_deg", directions.stream().map(OrderTable::theta).toList());
        tree.put("phi_r_deg", directions.stream().map(OrderTable::phi).toList());
        tree.put("efficiency", Arrays.copyOf(values(incidence, order, Efficiency::value), visible));
        tree.put("efficiency_low", Arrays.copyOf(values(incidence, order, Efficiency::low), visible));
        tree.put("efficiency_high", Arrays.copyOf(values(incidence, order, Efficiency::high), visible));
        tree.put("xyz", xyz);
        tree.put("srgb", xyz[1] > 0 ? srgb(xyz) : null);
        return tree;
    }
}
