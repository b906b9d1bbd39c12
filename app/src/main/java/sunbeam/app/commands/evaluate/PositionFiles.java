package sunbeam.app.commands.evaluate;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.plot.Plot;

/** Positions of the window as a table and as a plot. */
final class PositionFiles {
    private PositionFiles() {}

    static AtomicFile.StreamContent csv(Positions positions) {
        return stream -> {
            try (CsvWriter writer = new CsvWriter(stream, List.of("column", "row", "period_nm"))) {
                for (int i = 0; i < positions.periods().length; i++) {
                    writer.row(
                            positions.places().get(i).column(),
                            positions.places().get(i).row(),
                            positions.periods()[i] * 1e9);
                }
            }
        };
    }

    /** The share of positions below each period, beside the ensemble's period. */
    static BufferedImage draw(String title, Positions positions) {
        double[] periods =
                Arrays.stream(positions.sorted()).map(metres -> metres * 1e9).toArray();
        double[] shares = new double[periods.length];
        Arrays.setAll(shares, i -> 100 * (i + 0.5) / shares.length);
        Plot plot = new Plot(new Plot.Frame(
                title, Plot.Axis.linear("period / nm"), Plot.Axis.linear("positions with a shorter one / %")));
        plot.points("single positions of the window", periods, shares);
        if (!Double.isNaN(positions.ensemble())) {
            double ensemble = positions.ensemble() * 1e9;
            String name = String.format(Locale.ROOT, "mean over all positions: %.1f nm", ensemble);
            plot.line(name, new double[] {ensemble, ensemble}, new double[] {0, 100});
        }
        return plot.draw();
    }
}
