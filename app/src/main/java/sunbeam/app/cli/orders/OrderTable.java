package sunbeam.app.cli.orders;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Efficiencies of a surface's orders over wavelength and angle of incidence (docs/evaluation.md).
 *
 * @param thetas angles of the light to the normal, degrees
 * @param phi azimuth of the light, degrees
 * @param wavelengths meters, ascending
 * @param lights orders by angle, then by wavelength
 * @param cie light and observer for the orders' colors
 */
record OrderTable(
        Patch patch,
        GratingPeriod period,
        OrderLattice lattice,
        double[] thetas,
        double phi,
        double[] wavelengths,
        List<List<OrderLight>> lights,
        CieTable cie) {
    private static final int STRONGEST = 6;
    private static final int NAMED = 12;
    private static final double NANOMETER = 1e-9;
    // Luminance, relative to white, of an order's color on the screen: about that of pure red.
    private static final double LUMINANCE = 0.2;
    private static final List<String> COLUMNS = List.of(
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

    Verdict verdict() {
        return Verdict.of(patch, period);
    }

    private static List<Order> orders(List<OrderLight> some) {
        return some.stream()
                .flatMap(light -> light.efficiencies().keySet().stream())
                .distinct()
                .sorted(Comparator.comparingInt(Order::n).thenComparingInt(Order::m))
                .toList();
    }

    static List<Order> strongest(List<OrderLight> some) {
        return orders(some).stream()
                .sorted(Comparator.comparingDouble(order -> -Arrays.stream(values(some, order, Efficiency::value))
                        .filter(Double::isFinite)
                        .sum()))
                .limit(STRONGEST)
                .toList();
    }

    /** Returns a value of an order's efficiency under each light, NaN beyond the horizon. */
    static double[] values(List<OrderLight> some, Order order, ToDoubleFunction<Efficiency> value) {
        return some.stream()
                .mapToDouble(light -> value.applyAsDouble(light.at(order)))
                .toArray();
    }

    /** Returns the lights under which an order is above the horizon: those of the shortest wavelengths. */
    private static List<OrderLight> visible(List<OrderLight> some, Order order) {
        return some.stream().filter(light -> light.direction(order).isPresent()).toList();
    }

    List<String> lines() {
        List<OrderLight> first = lights.get(0);
        OrderLight middle = first.get(first.size() / 2);
        List<String> lines = new ArrayList<>();
        lines.add(Text.format(
                "light at %s degrees, azimuth %s degrees, %s: %.5f of it leaves, %.5f between the orders; a flat mirror sends %.5f",
                written(thetas[0]), written(phi), nanometers(middle), middle.sum(), middle.between(), middle.mirror()));
        for (Order order : strongest(first)) {
            Efficiency efficiency = middle.at(order);
            String interval = efficiency.low() == efficiency.value()
                    ? ""
                    : Text.format(" (%.5f to %.5f)", efficiency.low(), efficiency.high());
            lines.add("  order " + order.in(lattice)
                    + middle.direction(order)
                            .map(wr -> Text.format(
                                    " at theta_r %.1f, phi_r %.1f degrees: %.5f%s, color %s",
                                    theta(wr), phi(wr), efficiency.value(), interval, srgb(xyz(first, order))))
                            .orElse(" beyond the horizon"));
        }
        List<String> hidden = orders(first).stream()
                .filter(order -> visible(first, order).size() < first.size())
                .map(order -> order.in(lattice) + " from "
                        + nanometers(first.get(visible(first, order).size())))
                .toList();
        if (!hidden.isEmpty()) {
            lines.add("  beyond the horizon: " + String.join(", ", hidden.subList(0, Math.min(NAMED, hidden.size())))
                    + (hidden.size() > NAMED ? ", and " + (hidden.size() - NAMED) + " more (.json)" : ""));
        }
        return lines;
    }

    static String written(double value) {
        return Decimals.format(Math.rint(1000 * value) / 1000 + 0.0);
    }

    static String nanometers(OrderLight light) {
        return written(light.wavelength() / NANOMETER) + " nm";
    }

    private static double theta(Direction direction) {
        return Math.toDegrees(Math.atan2(Math.hypot(direction.x(), direction.y()), direction.z()));
    }

    private static double phi(Direction direction) {
        return Math.toDegrees(Math.atan2(direction.y(), direction.x())) + 0.0;
    }

    /** Returns X, Y, Z of an order's light, relative to the luminance of the incident light of these wavelengths. */
    private double[] xyz(List<OrderLight> some, Order order) {
        double[] efficiencies = Arrays.stream(values(some, order, Efficiency::value))
                .map(value -> Double.isNaN(value) ? 0 : value)
                .toArray();
        int last = wavelengths.length - 1;
        double step = last > 0 ? wavelengths[1] - wavelengths[0] : 1;
        double[] sums = new double[4];
        // Lamps have lines: their weights are summed at each nanometer, between which efficiencies are linear.
        for (double at = wavelengths[0]; at <= wavelengths[last] + NANOMETER / 2; at += NANOMETER) {
            double place = Math.min(last, (at - wavelengths[0]) / step);
            int below = (int) place;
            double rest = place - below;
            double efficiency = (1 - rest) * efficiencies[below] + rest * efficiencies[Math.min(last, below + 1)];
            for (int c = 0; c < 3; c++) {
                sums[c] += efficiency * cie.at(at, c);
            }
            sums[3] += cie.at(at, 1);
        }
        return new double[] {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
    }

    private static String srgb(double... xyz) {
        return Text.format("#%06x", new DisplayTransform(LUMINANCE / xyz[1], Tone.COMPRESS).rgb(xyz));
    }

    /** Returns one row for each order, wavelength and angle of incidence; its directions are columns of {@code reflectance}. */
    AtomicFile.StreamContent csv() {
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i < thetas.length; i++) {
            for (Order order : orders(lights.get(i))) {
                for (OrderLight light : visible(lights.get(i), order)) {
                    Direction wr = light.direction(order).orElseThrow();
                    Efficiency found = light.at(order);
                    double nanometers = light.wavelength() / NANOMETER;
                    rows.add(new double[] {
                        thetas[i],
                        phi,
                        theta(wr),
                        phi(wr),
                        nanometers,
                        order.m(),
                        order.n(),
                        found.value(),
                        found.low(),
                        found.high(),
                        light.sum(),
                        light.mirror()
                    });
                }
            }
        }
        return CsvWriter.numbers(COLUMNS, rows.size(), rows::get);
    }

    Map<String, Object> tree() {
        Map<String, Object> tree = ReportFields.of(patch, period, verdict());
        tree.put("program", "Sunbeam " + Version.number());
        tree.put(
                "lattice_per_m",
                Stream.concat(Stream.of(lattice.first()), lattice.second().stream())
                        .map(frequency -> List.of(frequency.x(), frequency.y()))
                        .toList());
        tree.put("light", cie.description());
        tree.put("wavelengths_m", wavelengths);
        tree.put(
                "incidences",
                IntStream.range(0, thetas.length)
                        .mapToObj(i -> tree(thetas[i], lights.get(i)))
                        .toList());
        return tree;
    }

    private Map<String, Object> tree(double theta, List<OrderLight> some) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("theta_i_deg", theta);
        tree.put("phi_i_deg", phi);
        tree.put("mirror", some.stream().map(OrderLight::mirror).toList());
        tree.put("sum", some.stream().map(OrderLight::sum).toList());
        tree.put("between_orders", some.stream().map(OrderLight::between).toList());
        tree.put("orders", orders(some).stream().map(order -> tree(some, order)).toList());
        return tree;
    }

    private Map<String, Object> tree(List<OrderLight> some, Order order) {
        List<OrderLight> visible = visible(some, order);
        List<Direction> directions = visible.stream()
                .flatMap(light -> light.direction(order).stream())
                .toList();
        double[] xyz = xyz(some, order);
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("m", order.m());
        tree.put("n", order.n());
        tree.put("beyond_horizon_from_m", visible.size() < some.size() ? wavelengths[visible.size()] : null);
        tree.put("theta_r_deg", directions.stream().map(OrderTable::theta).toList());
        tree.put("phi_r_deg", directions.stream().map(OrderTable::phi).toList());
        tree.put("efficiency", values(visible, order, Efficiency::value));
        tree.put("efficiency_low", values(visible, order, Efficiency::low));
        tree.put("efficiency_high", values(visible, order, Efficiency::high));
        tree.put("xyz", xyz);
        tree.put("srgb", xyz[1] > 0 ? srgb(xyz) : null);
        return tree;
    }
}
