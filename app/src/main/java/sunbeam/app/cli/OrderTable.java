package sunbeam.app.cli;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.OrderLattice;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderLight;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Efficiencies of a surface's orders over wavelength and angle of incidence, for one azimuth of the light in degrees. */
record OrderTable(
        Patch patch,
        GratingPeriod period,
        Verdict verdict,
        OrderLattice lattice,
        double phi,
        List<Incidence> incidences,
        CieTable cie) {
    private static final int STRONGEST = 6;
    private static final int NAMED = 12;
    private static final double NANOMETER = 1e-9;
    // Orders at half of the sampling frequency deviate by rounding.
    private static final double ROUNDING = 1e-9;
    // Share of an order's light in lines beside it, below which they are not told.
    private static final double FEW_BESIDE = 0.01;
    // Luminance, relative to white, of an order's color on the screen: about that of pure red.
    private static final double LUMINANCE = 0.2;
    private static final List<String> COLUMNS =
            List.of("theta_i phi_i theta_r phi_r wavelength m n efficiency low high sum mirror".split(" ", -1));

    /** All orders at one angle of incidence, degrees to the normal, with lights by ascending wavelength. */
    record Incidence(double theta, List<OrderLight> lights, List<Series> orders) {
        Incidence(double theta, List<OrderLight> lights) {
            this(theta, lights, series(lights));
        }
    }

    /** An order under the lights that leave it above the horizon; over wavelength, those of the shortest ones. */
    record Series(Order order, List<Seen> seen) {
        double[] values(ToDoubleFunction<Seen> value) {
            return seen.stream().mapToDouble(value).toArray();
        }

        private double sum() {
            return seen.stream().mapToDouble(one -> one.efficiency.value()).sum();
        }
    }

    record Seen(OrderLight light, Direction wr, OrderLight.Efficiency efficiency) {
        private double theta() {
            return Math.toDegrees(Math.atan2(Math.hypot(wr.x(), wr.y()), wr.z()));
        }

        private double phi() {
            return Math.toDegrees(Math.atan2(wr.y(), wr.x())) + 0.0;
        }
    }

    static List<Series> series(List<OrderLight> lights) {
        return lights.stream()
                .flatMap(light -> light.efficiencies().keySet().stream())
                .distinct()
                .sorted(Comparator.comparingInt(Order::n).thenComparingInt(Order::m))
                .map(order -> new Series(order, seen(order, lights)))
                .toList();
    }

    private static List<Seen> seen(Order order, List<OrderLight> lights) {
        return lights.stream()
                .flatMap(light -> light.direction(order).map(wr -> new Seen(light, wr, light.at(order))).stream())
                .toList();
    }

    static List<Series> strongest(List<Series> orders) {
        return orders.stream()
                .sorted(Comparator.comparingDouble(Series::sum).reversed())
                .limit(STRONGEST)
                .toList();
    }

    /** Returns the orders to draw, by their numbers: of a grating all up to the strongest one farthest from the mirror's. */
    static List<Series> shown(List<Series> orders) {
        List<Series> strongest = strongest(orders);
        boolean grating = orders.stream().allMatch(series -> series.order.n() == 0);
        int farthest = strongest.stream()
                .mapToInt(series -> Math.abs(series.order.m()))
                .max()
                .orElse(0);
        return orders.stream()
                .filter(series -> strongest.contains(series) || (grating && Math.abs(series.order.m()) <= farthest))
                .toList();
    }

    List<String> lines() {
        Incidence first = incidences.get(0);
        OrderLight middle = first.lights.get(first.lights.size() / 2);
        String light = Text.format(
                "light at %s degrees, azimuth %s degrees, %s: ",
                written(first.theta), written(phi), nanometers(middle));
        String leaving = Text.format(
                "%.5f of it leaves, %.5f between the orders; a flat mirror sends %.5f",
                middle.sum(), middle.between(), middle.mirror());
        List<String> lines = new ArrayList<>(List.of(verdict.sentence(), light + leaving));
        for (Series series : strongest(first.orders)) {
            Optional<Seen> visible = series.seen.stream()
                    .filter(seen -> seen.light.equals(middle))
                    .findFirst();
            String words = visible.map(seen -> describe(seen) + ", color " + srgb(xyz(first, series)))
                    .orElse(" beyond the horizon");
            lines.add("  order " + series.order.in(lattice) + words);
        }
        List<String> hidden = first.orders.stream()
                .filter(series -> series.seen.size() < first.lights.size())
                .map(series -> series.order.in(lattice) + " from " + nanometers(first.lights.get(series.seen.size())))
                .toList();
        if (!hidden.isEmpty()) {
            lines.add("  beyond the horizon: " + named(hidden));
        }
        List<String> aliases = first.orders.stream()
                .filter(series -> isBeyondSampling(series.order))
                .map(series -> series.order.in(lattice))
                .toList();
        if (!aliases.isEmpty()) {
            lines.add("  beyond half of the sampling frequency: " + named(aliases)
                    + "; samples repeat the spectrum, so their light may not be the surface's own");
        }
        return lines;
    }

    private static String named(List<String> orders) {
        return String.join(", ", orders.subList(0, Math.min(NAMED, orders.size())))
                + (orders.size() > NAMED ? ", and " + (orders.size() - NAMED) + " more (.json)" : "");
    }

    private boolean isBeyondSampling(Order order) {
        SpatialFrequency frequency = lattice.frequency(order);
        double most = 0.5 + ROUNDING;
        return Math.abs(frequency.x()) * patch.heights().pitchX() > most
                || Math.abs(frequency.y()) * patch.heights().pitchY() > most;
    }

    private static String describe(Seen seen) {
        OrderLight.Efficiency efficiency = seen.efficiency;
        String interval = efficiency.low() == efficiency.value()
                ? ""
                : Text.format(" (%.5f to %.5f)", efficiency.low(), efficiency.high());
        String beside = efficiency.beside() < FEW_BESIDE * efficiency.value()
                ? ""
                : Text.format(
                        ", %.5f of it in lines beside the order, no multiples of the period", efficiency.beside());
        return Text.format(
                " at theta_r %.1f, phi_r %.1f degrees: %.5f%s%s",
                seen.theta(), seen.phi(), efficiency.value(), interval, beside);
    }

    static String written(double value) {
        return Decimals.format(Math.rint(1000 * value) / 1000 + 0.0);
    }

    static String nanometers(OrderLight light) {
        return written(light.wavelength() / NANOMETER) + " nm";
    }

    /** Returns X, Y, Z of an order's light, relative to the luminance of the incident light of these wavelengths. */
    private double[] xyz(Incidence incidence, Series series) {
        List<OrderLight> lights = incidence.lights;
        int last = lights.size() - 1;
        double shortest = lights.get(0).wavelength();
        double step = last > 0 ? lights.get(1).wavelength() - shortest : 1;
        double[] sums = new double[4];
        // Lamps have lines: their weights are summed at each nanometer, between which efficiencies are linear.
        for (double at = shortest; at <= lights.get(last).wavelength() + NANOMETER / 2; at += NANOMETER) {
            double place = Math.min(last, (at - shortest) / step);
            int below = (int) place;
            double rest = place - below;
            double efficiency =
                    (1 - rest) * efficiency(series, below) + rest * efficiency(series, Math.min(last, below + 1));
            for (int c = 0; c < 3; c++) {
                sums[c] += efficiency * cie.at(at, c);
            }
            sums[3] += cie.at(at, 1);
        }
        return new double[] {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
    }

    private static double efficiency(Series series, int wavelength) {
        return wavelength < series.seen.size()
                ? series.seen.get(wavelength).efficiency.value()
                : 0;
    }

    private static String srgb(double... xyz) {
        return Text.format("#%06x", new DisplayTransform(LUMINANCE / xyz[1], Tone.COMPRESS).rgb(xyz));
    }

    /** Returns one row for each order, wavelength and angle of incidence; its directions are columns of {@code reflectance}. */
    StreamContent csv() {
        List<double[]> rows = incidences.stream()
                .flatMap(incidence -> incidence.orders.stream()
                        .flatMap(series -> series.seen.stream().map(seen -> row(incidence.theta, series.order, seen))))
                .toList();
        return CsvWriter.numbers(COLUMNS, Set.of("m", "n"), rows.size(), rows::get);
    }

    private double[] row(double theta, Order order, Seen seen) {
        return new double[] {
            theta,
            phi,
            seen.theta(),
            seen.phi(),
            seen.light.wavelength() / NANOMETER,
            order.m(),
            order.n(),
            seen.efficiency.value(),
            seen.efficiency.low(),
            seen.efficiency.high(),
            seen.light.sum(),
            seen.light.mirror()
        };
    }

    Map<String, Object> tree() {
        Map<String, Object> tree = JsonOption.fields(patch, period, verdict);
        tree.put("program", "Sunbeam " + Environment.version());
        Stream<SpatialFrequency> basis = Stream.concat(Stream.of(lattice.first()), lattice.second().stream());
        tree.put(
                "lattice_per_m",
                basis.map(vector -> List.of(vector.x(), vector.y())).toList());
        tree.put("light", cie.description());
        List<OrderLight> lights = incidences.get(0).lights;
        tree.put("wavelengths_m", lights.stream().map(OrderLight::wavelength).toList());
        tree.put("incidences", incidences.stream().map(this::tree).toList());
        return tree;
    }

    private Map<String, Object> tree(Incidence incidence) {
        List<OrderLight> lights = incidence.lights;
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("theta_i_deg", incidence.theta);
        tree.put("phi_i_deg", phi);
        tree.put("mirror", lights.stream().map(OrderLight::mirror).toList());
        tree.put("sum", lights.stream().map(OrderLight::sum).toList());
        tree.put("between_orders", lights.stream().map(OrderLight::between).toList());
        List<Series> orders = incidence.orders;
        tree.put(
                "orders", orders.stream().map(series -> tree(incidence, series)).toList());
        return tree;
    }

    private Map<String, Object> tree(Incidence incidence, Series series) {
        List<OrderLight> hidden = incidence.lights.subList(series.seen.size(), incidence.lights.size());
        double[] xyz = xyz(incidence, series);
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("m", series.order.m());
        tree.put("n", series.order.n());
        tree.put(
                "beyond_horizon_from_m", hidden.isEmpty() ? null : hidden.get(0).wavelength());
        tree.put("theta_r_deg", series.values(Seen::theta));
        tree.put("phi_r_deg", series.values(Seen::phi));
        tree.put("efficiency", series.values(seen -> seen.efficiency.value()));
        tree.put("efficiency_low", series.values(seen -> seen.efficiency.low()));
        tree.put("efficiency_high", series.values(seen -> seen.efficiency.high()));
        tree.put("efficiency_beside", series.values(seen -> seen.efficiency.beside()));
        tree.put("beyond_sampling", isBeyondSampling(series.order));
        tree.put("xyz", xyz);
        tree.put("srgb", xyz[1] > 0 ? srgb(xyz) : null);
        return tree;
    }
}
