package sunbeam.app.cli.orders;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.app.cli.orders.OrderTable.Incidence;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderLight;
import sunbeam.precompute.analysis.OrderLight.Efficiency;

/** Plots of the strongest orders' efficiencies, of their sum and of a mirror, one for each angle of incidence. */
final class OrderPlot {
    private static final int WIDTH = 1100;
    private static final int HEIGHT = 560;
    // Largest number of plots below each other.
    private static final int MOST = 12;

    private OrderPlot() {}

    /** Draws the verdict and, below it, efficiency over wavelength, or over the angle of incidence if there is one wavelength. */
    static BufferedImage draw(OrderTable table) {
        Sheet sheet = new Sheet(WIDTH)
                .heading(table.patch().name() + ": " + table.verdict().sentence());
        if (table.nanometers().length == 1 && table.incidences().size() > 1) {
            return sheet.row(overAngle(table)).draw();
        }
        int step = (table.incidences().size() + MOST - 1) / MOST;
        for (int i = 0; i < table.incidences().size(); i += step) {
            sheet.row(overWavelength(table, table.incidences().get(i)));
        }
        return sheet.draw();
    }

    private static BufferedImage overWavelength(OrderTable table, Incidence incidence) {
        Plot plot = plot(
                "light at " + OrderTable.written(incidence.theta()) + " degrees, azimuth "
                        + OrderTable.written(table.phi()) + " degrees",
                "wavelength / nm");
        for (Order order : table.strongest(incidence)) {
            add(plot, table, order, table.nanometers(), table.values(incidence, order, Efficiency::value));
        }
        return plot.line("all light", table.nanometers(), incidence.all(OrderLight::sum))
                .outline("flat mirror", table.nanometers(), incidence.all(OrderLight::mirror))
                .draw();
    }

    private static BufferedImage overAngle(OrderTable table) {
        double[] angles =
                table.incidences().stream().mapToDouble(Incidence::theta).toArray();
        Plot plot = plot(
                OrderTable.written(table.nanometers()[0]) + " nm, azimuth of the light "
                        + OrderTable.written(table.phi()) + " degrees",
                "angle of incidence theta_i / degrees");
        for (Order order : table.strongest(table.incidences().get(angles.length / 2))) {
            double[] values = table.incidences().stream()
                    .mapToDouble(incidence -> table.at(incidence, order, 0).value())
                    .toArray();
            add(plot, table, order, angles, values);
        }
        return plot.line(
                        "all light",
                        angles,
                        table.incidences().stream()
                                .mapToDouble(
                                        incidence -> incidence.lights().get(0).sum())
                                .toArray())
                .outline(
                        "flat mirror",
                        angles,
                        table.incidences().stream()
                                .mapToDouble(
                                        incidence -> incidence.lights().get(0).mirror())
                                .toArray())
                .draw();
    }

    private static Plot plot(String title, String x) {
        return Plot.linear(title, x, "efficiency / share of the incident light", WIDTH, HEIGHT)
                .fromZero();
    }

    /** Adds an order's line where it is above the horizon. */
    private static void add(Plot plot, OrderTable table, Order order, double[] x, double[] values) {
        int[] seen = IntStream.range(0, x.length)
                .filter(i -> Double.isFinite(values[i]))
                .toArray();
        if (seen.length > 0) {
            plot.line(
                    "order " + order.in(table.lattice()),
                    Arrays.stream(seen).mapToDouble(i -> x[i]).toArray(),
                    Arrays.stream(seen).mapToDouble(i -> values[i]).toArray());
        }
    }
}
