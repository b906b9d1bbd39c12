package sunbeam.app.cli.orders;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.ToDoubleFunction;
import sunbeam.app.cli.orders.OrderTable.Incidence;
import sunbeam.app.cli.orders.OrderTable.Series;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.analysis.OrderLight;

final class OrderPlot {
    private static final int WIDTH = 1100;
    private static final int HEIGHT = 560;
    private static final int MOST = 12;

    private OrderPlot() {}

    static BufferedImage draw(OrderTable table) {
        Sheet sheet = new Sheet(WIDTH)
                .heading(table.patch().name() + ": " + table.verdict().sentence());
        List<Incidence> incidences = table.incidences();
        int angles = incidences.size();
        String azimuth = ", azimuth of the light " + OrderTable.written(table.phi()) + " degrees";
        if (incidences.get(0).lights().size() == 1 && angles > 1) {
            List<OrderLight> lights =
                    incidences.stream().map(one -> one.lights().get(0)).toList();
            String title = OrderTable.nanometers(lights.get(0)) + azimuth;
            ToDoubleFunction<OrderLight> theta =
                    light -> Math.toDegrees(Math.acos(light.wi().z()));
            return sheet.row(plot(
                            title, "angle of incidence theta_i / degrees", theta, lights, OrderTable.series(lights)))
                    .draw();
        }
        for (int i = 0; i < angles; i += (angles + MOST - 1) / MOST) {
            Incidence one = incidences.get(i);
            String title = "light at " + OrderTable.written(one.theta()) + " degrees" + azimuth;
            sheet.row(plot(title, "wavelength / nm", light -> 1e9 * light.wavelength(), one.lights(), one.orders()));
        }
        return sheet.draw();
    }

    private static BufferedImage plot(
            String title, String axis, ToDoubleFunction<OrderLight> x, List<OrderLight> lights, List<Series> orders) {
        Plot plot = Plot.linear(title, axis, "efficiency / share of the incident light", WIDTH, HEIGHT)
                .fromZero();
        for (Series series : OrderTable.strongest(orders)) {
            plot.line(
                    "order " + series.order().in(lights.get(0).lattice()),
                    series.values(seen -> x.applyAsDouble(seen.light())),
                    series.values(seen -> seen.efficiency().value()));
        }
        double[] all = lights.stream().mapToDouble(x).toArray();
        return plot.line(
                        "all light",
                        all,
                        lights.stream().mapToDouble(OrderLight::sum).toArray())
                .outline(
                        "flat mirror",
                        all,
                        lights.stream().mapToDouble(OrderLight::mirror).toArray())
                .draw();
    }
}
