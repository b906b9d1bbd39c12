package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.GraphicsException;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;

/**
 * How the cost of {@code full} and {@code table} grows with pixels, samples, relief and window, one of them varied at a time.
 *
 * @param points by what is varied, then by method
 */
record Growth(String patch, List<Point> points, List<String> remarks) {
    /** Of both methods: cost over an axis has the same shape at any tolerance. */
    private static final double TOLERANCE = 1e-2;

    // Each times the surface's own, or what is asked for.
    private static final double[] FACTORS = {0.5, 1, 2};
    private static final int LEAST_PIXELS = 16;

    /** What was measured, and what was varied by which factor. */
    record Point(String axis, double factor, Measured measured) {
        Map<String, Object> fields() {
            Map<String, Object> fields = new LinkedHashMap<>(Map.of("varied", axis));
            fields.put("factor", factor);
            fields.putAll(measured.fields());
            return fields;
        }
    }

    /**
     * Measures along all axes.
     *
     * @param asked window and average; half of that window is where it grows from, since tables of twice it take minutes
     */
    static Growth measure(Meter meter, Environment environment, Patch patch, GaussianArea asked) {
        HeightMap heights = patch.heights();
        double length = 0.5 * asked.window().coherenceLength();
        GaussianArea area = asked.with(CoherenceWindow.ofCoherenceLength(length));
        Growth growth = new Growth(patch.name(), new ArrayList<>(), new ArrayList<>());
        try (Progress progress = Progress.start("Growth on " + patch.name(), 4L * FACTORS.length)) {
            for (double factor : FACTORS) {
                int pixels = Math.max(LEAST_PIXELS, (int) Math.round(factor * meter.size()));
                DiffractionSetup whole = setup(environment, patch, heights);
                growth.add("pixels", factor, meter.withSize(pixels), whole, area);
                progress.step(1);
                growth.add("samples", factor, meter, setup(environment, patch, resampled(heights, factor)), area);
                progress.step(1);
                HeightMap scaled = heights.map(height -> factor * height);
                growth.add("relief", factor, meter, setup(environment, patch, scaled), area);
                progress.step(1);
                GaussianArea other = area.with(CoherenceWindow.ofCoherenceLength(factor * length));
                growth.add("window", factor, meter, whole, other);
                progress.step(1);
            }
        }
        growth.points.sort(Comparator.comparing(Point::axis)
                .thenComparing(point -> point.measured().method()));
        return growth;
    }

    /** Other heights of a patch, without anything else that is known of it. */
    static DiffractionSetup setup(Environment environment, Patch patch, HeightMap heights) {
        return new DiffractionSetup(
                new Patch(patch.name(), heights, patch.source(), List.of()), environment, warning -> {});
    }

    private void add(String axis, double factor, Meter sized, DiffractionSetup setup, GaussianArea lit) {
        for (Method method : List.of(FullMethod.within(TOLERANCE).with(lit), new TableMethod(TOLERANCE, lit))) {
            String name = method.type().label();
            try {
                points.add(new Point(axis, factor, sized.measure(setup, name, method, Optional.empty())));
            } catch (GraphicsException | SettingException unmeasured) {
                remarks.add(Text.format("%s at %.4g times the %s: %s", name, factor, axis, unmeasured.getMessage()));
            }
        }
    }

    /** The same period with so many times the samples a side, linear between those that there are. */
    static HeightMap resampled(HeightMap map, double factor) {
        int columns = (int) Math.round(factor * map.columns());
        int rows = (int) Math.round(factor * map.rows());
        double[] heights = new double[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double x = (double) column * map.columns() / columns;
                double y = (double) row * map.rows() / rows;
                int left = (int) x;
                int above = (int) y;
                int right = (left + 1) % map.columns();
                int below = (above + 1) % map.rows();
                double top = map.at(left, above) + (x - left) * (map.at(right, above) - map.at(left, above));
                double bottom = map.at(left, below) + (x - left) * (map.at(right, below) - map.at(left, below));
                heights[row * columns + column] = top + (y - above) * (bottom - top);
            }
        }
        return new HeightMap(columns, rows, map.width() / columns, map.height() / rows, heights);
    }
}
