package sunbeam.app.commands.compare;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.FittedNames;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.text.Text;

/** The picture of a compared table: both lights over the viewer's angle, their colors, and by how much they differ. */
final class TableSheet {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
    private static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 18);
    private static final int PANEL = 720;
    private static final int HEIGHT = 460;
    private static final int MARGIN = 24;
    private static final int STRIP = 44;
    private static final int LINE = 22;
    // More lights than these are one cloud of points.
    private static final int MOST_LIGHTS = 6;
    private static final String ANGLE = "angle to the viewer / degrees (negative towards -x)";

    private TableSheet() {}

    static BufferedImage draw(MeasuredTable table, TableComparison comparison, String title) {
        boolean hasColors = table.hasColors();
        List<String> lines = comparison.lines();
        Map<String, int[]> lights = lights(table);
        int strips = hasColors ? lights.size() * (STRIP + LINE) + MARGIN : 0;
        return Sheet.of(2 * PANEL + 3 * MARGIN, HEIGHT + strips + LINE * lines.size() + 3 * MARGIN, graphics -> {
            light(table, comparison, lights, title).ifPresent(image -> graphics.drawImage(image, MARGIN, MARGIN, null));
            difference(table, comparison, lights)
                    .ifPresent(image -> graphics.drawImage(image, 2 * MARGIN + PANEL, MARGIN, null));
            graphics.setFont(FONT);
            int y = hasColors ? strips(graphics, comparison, lights) : HEIGHT + 2 * MARGIN;
            for (int i = 0; i < lines.size(); i++) {
                graphics.drawString(lines.get(i), MARGIN, y + LINE * i + 10);
            }
        });
    }

    /** Where they end. */
    private static int strips(Graphics2D graphics, TableComparison comparison, Map<String, int[]> lights) {
        int y = HEIGHT + 2 * MARGIN;
        for (Map.Entry<String, int[]> light : lights.entrySet()) {
            graphics.drawString(light.getKey() + ": measured above computed, by the viewer's angle", MARGIN, y + 14);
            strip(graphics, comparison.measuredXyz(), comparison.exposure(), light.getValue(), y + LINE);
            strip(graphics, comparison.computedXyz(), comparison.exposure(), light.getValue(), y + LINE + STRIP / 2);
            graphics.setColor(Color.BLACK);
            y += STRIP + LINE;
        }
        return y + MARGIN;
    }

    /** Rows of each direction of light, by the viewer's angle. */
    private static Map<String, int[]> lights(MeasuredTable table) {
        Map<String, List<Integer>> found = new LinkedHashMap<>();
        for (int row = 0; row < table.values().size(); row++) {
            double[] cells = table.directions().row(row);
            String name = Text.format("light at theta %.1f, phi %.1f", cells[0], cells[1]);
            found.computeIfAbsent(name, light -> new ArrayList<>()).add(row);
        }
        if (found.size() > MOST_LIGHTS) {
            List<Integer> all =
                    IntStream.range(0, table.values().size()).boxed().toList();
            found = Map.of("light from " + found.size() + " directions", all);
        }
        Map<String, int[]> sorted = new LinkedHashMap<>();
        found.forEach((name, rows) -> sorted.put(
                name,
                rows.stream()
                        .sorted(Comparator.comparingDouble(row -> angle(table, row)))
                        .mapToInt(Integer::intValue)
                        .toArray()));
        return sorted;
    }

    private static double angle(MeasuredTable table, int row) {
        double[] cells = table.directions().row(row);
        return Math.cos(Math.toRadians(cells[3])) < -1e-9 ? -cells[2] : cells[2];
    }

    private static double[] angles(MeasuredTable table, int[] rows) {
        return IntStream.of(rows).mapToDouble(row -> angle(table, row)).toArray();
    }

    /** Nothing where none is positive in both. */
    private static Optional<BufferedImage> light(
            MeasuredTable table, TableComparison comparison, Map<String, int[]> lights, String title) {
        String what = table.hasColors() ? "Y" : "BRDF";
        Plot plot = new Plot(new Plot.Frame(
                        FittedNames.of(title, TITLE_FONT, PANEL - 2 * MARGIN),
                        Plot.Axis.linear(ANGLE),
                        Plot.Axis.logarithmic(what),
                        PANEL,
                        HEIGHT))
                .legendBelow();
        double[] measured = levels(table, comparison, false);
        double[] computed = levels(table, comparison, true);
        return drawn(plot, lights, row -> measured[row] > 0 && computed[row] > 0, (light, rows, color) -> {
            String name = lights.size() == 1 ? "" : ", " + light;
            plot.points("measured" + name, angles(table, rows), of(measured, rows), color);
            plot.points("computed" + name, angles(table, rows), of(computed, rows), color + 1);
        });
    }

    private interface Series {
        void add(String light, int[] rows, int color);
    }

    /** Of those rows that can be shown; nothing where there are none. */
    private static Optional<BufferedImage> drawn(
            Plot plot, Map<String, int[]> lights, IntPredicate isShown, Series series) {
        boolean isEmpty = true;
        int color = 0;
        for (Map.Entry<String, int[]> light : lights.entrySet()) {
            int[] shown = IntStream.of(light.getValue()).filter(isShown).toArray();
            if (shown.length > 0) {
                isEmpty = false;
                series.add(light.getKey(), shown, color);
            }
            color += 2;
        }
        return isEmpty ? Optional.empty() : Optional.of(plot.draw());
    }

    /** Luminances, or the mean of each row's values. */
    private static double[] levels(MeasuredTable table, TableComparison comparison, boolean computed) {
        if (table.hasColors()) {
            return (computed ? comparison.computedXyz() : comparison.measuredXyz())
                    .stream().mapToDouble(xyz -> xyz[1]).toArray();
        }
        return (computed ? comparison.computed() : table.values())
                .stream()
                        .mapToDouble(row -> IntStream.range(0, row.length)
                                .mapToDouble(i -> row[i])
                                .average()
                                .orElseThrow())
                        .toArray();
    }

    private static double[] of(double[] values, int[] rows) {
        return IntStream.of(rows).mapToDouble(row -> values[row]).toArray();
    }

    /** Nothing where none is finite. */
    private static Optional<BufferedImage> difference(
            MeasuredTable table, TableComparison comparison, Map<String, int[]> lights) {
        double[] values = table.hasColors() ? comparison.differences() : comparison.errors();
        String what = table.hasColors() ? "CIEDE2000" : "relative error";
        Plot plot = Plot.linear("Difference", ANGLE, what, PANEL, HEIGHT).legendBelow();
        return drawn(
                plot,
                lights,
                row -> Double.isFinite(values[row]),
                (light, rows, color) -> plot.points(light, angles(table, rows), of(values, rows), color));
    }

    private static void strip(Graphics2D graphics, List<double[]> xyz, double exposure, int[] rows, int y) {
        DisplayTransform display = new DisplayTransform(exposure, Tone.COMPRESS);
        int width = 2 * PANEL + MARGIN;
        for (int i = 0; i < rows.length; i++) {
            int from = (int) ((long) width * i / rows.length);
            int to = (int) ((long) width * (i + 1) / rows.length);
            graphics.setColor(new Color(display.rgb(xyz.get(rows[i]))));
            graphics.fillRect(MARGIN + from, y, to - from, STRIP / 2);
        }
    }
}
