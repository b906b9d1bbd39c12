package sunbeam.app.cli.orders;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderLight;
import sunbeam.precompute.analysis.OrderLight.Efficiency;

/** Plots of the strongest orders' efficiencies, of their sum and of a mirror. */
final class OrderPlot {
    private static final int WIDTH = 1100;
    private static final int HEIGHT = 560;
    private static final int MOST = 12;

    private OrderPlot() {}

    static BufferedImage draw(OrderTable table) {
        Sheet sheet = new Sheet(WIDTH)
                .heading(table.patch().name() + ": " + table.verdict().sentence());
        int angles = table.thetas().length;
        String azimuth = ", azimuth of the light " + OrderTable.written(table.phi()) + " degrees";
        if (table.wavelengths().length == 1 && angles > 1) {
            List<OrderLight> lights =
                    table.lights().stream().map(lit -> lit.get(0)).toList();
            String title = OrderTable.nanometers(lights.get(0)) + azimuth;
            return sheet.row(plot(title, "angle of incidence theta_i / degrees", table.thetas(), lights))
                    .draw();
        }
        double[] nanometers =
                Arrays.stream(table.wavelengths()).map(meters -> 1e9 * meters).toArray();
        for (int i = 0; i < angles; i += (angles + MOST - 1) / MOST) {
            String title = "light at " + OrderTable.written(table.thetas()[i]) + " degrees" + azimuth;
            sheet.row(plot(title, "wavelength / nm", nanometers, table.lights().get(i)));
        }
        return sheet.draw();
    }

    private static BufferedImage plot(String title, String axis, double[] x, List<OrderLight> lights) {
        Plot plot = Plot.linear(title, axis, "efficiency / share of the incident light", WIDTH, HEIGHT)
                .fromZero();
        for (Order order : OrderTable.strongest(lights)) {
            double[] values = OrderTable.values(lights, order, Efficiency::value);
            int[] seen = IntStream.range(0, x.length)
                    .filter(i -> Double.isFinite(values[i]))
                    .toArray();
            plot.line(
                    "order " + order.in(lights.get(0).lattice()),
                    Arrays.stream(seen).mapToDouble(i -> x[i]).toArray(),
                    Arrays.stream(seen).mapToDouble(i -> values[i]).toArray());
        }
        return plot.line(
                        "all light",
                        x,
                        lights.stream().mapToDouble(OrderLight::sum).toArray())
                .outline(
                        "flat mirror",
                        x,
                        lights.stream().mapToDouble(OrderLight::mirror).toArray())
                .draw();
    }
}
