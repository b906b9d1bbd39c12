package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import jrtr.GraphicsException;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.SettingException;

/** Measures how the cost of {@code full} and {@code table} grows with pixels, samples, relief and window. */
final class GrowthExperiment {
    /** What both keep: cost over an axis has the same shape at any tolerance. */
    static final double TOLERANCE = 1e-2;

    /**
     * Where cost is measured.
     *
     * @param pixels widths of maps
     * @param samples along a side of the patch
     * @param reliefs metres
     * @param coherenceLengths metres
     */
    record Axes(List<Integer> pixels, List<Integer> samples, List<Double> reliefs, List<Double> coherenceLengths) {
        static final Axes STANDARD = new Axes(
                List.of(128, 256, 512),
                List.of(256, 512, 1024),
                List.of(0.1e-6, 0.3e-6, 1e-6),
                List.of(16e-6, 32e-6, 65e-6));
    }

    private final Meter meter;
    private final Environment environment;
    private final Patch base;
    private final GaussianArea area;
    private final List<Growth.Point> points = new ArrayList<>();
    private final List<String> remarks = new ArrayList<>();

    /**
     * An experiment on one surface.
     *
     * @param base the surface that is drawn, resampled and stretched
     * @param area window and average
     */
    GrowthExperiment(Meter meter, Environment environment, Patch base, GaussianArea area) {
        this.meter = meter;
        this.environment = environment;
        this.base = base;
        this.area = area;
    }

    /** Along all axes. */
    List<Growth> run(Axes axes) {
        return List.of(pixels(axes), samples(axes), relief(axes), coherence(axes));
    }

    private Growth pixels(Axes axes) {
        for (int size : axes.pixels()) {
            measure(size, meter.of(size), base.heights(), area);
        }
        return end("pixels", "width and height of the map / pixels");
    }

    private Growth samples(Axes axes) {
        for (int side : axes.samples()) {
            measure(side, meter, resampled(base.heights(), side), area);
        }
        return end("samples", "samples along a side of the patch");
    }

    private Growth relief(Axes axes) {
        double own = base.heights().relief();
        if (own == 0) {
            remarks.add("The patch has no relief to stretch");
            return end("relief", "relief / um");
        }
        for (double relief : axes.reliefs()) {
            measure(relief * 1e6, meter, base.heights().map(height -> height * relief / own), area);
        }
        return end("relief", "relief / um");
    }

    private Growth coherence(Axes axes) {
        for (double length : axes.coherenceLengths()) {
            GaussianArea other = area.with(CoherenceWindow.ofCoherenceLength(length));
            measure(length * 1e6, meter, base.heights(), other);
        }
        return end("window", "coherence length / um");
    }

    private Growth end(String key, String axis) {
        Growth growth = new Growth(key, axis, points, remarks);
        points.clear();
        remarks.clear();
        return growth;
    }

    private void measure(double x, Meter sized, HeightMap heights, GaussianArea lit) {
        DiffractionSetup setup = new DiffractionSetup(
                new Patch(base.name(), heights, base.source(), List.of()), environment, warning -> {});
        add(x, sized, setup, "full", FullMethod.within(TOLERANCE).with(lit));
        add(x, sized, setup, "table", new TableMethod(TOLERANCE, lit));
    }

    private void add(double x, Meter sized, DiffractionSetup setup, String name, Method method) {
        try {
            points.add(new Growth.Point(x, sized.measure(setup, name, method, Optional.empty())));
        } catch (GraphicsException | SettingException unmeasured) {
            remarks.add(String.format(Locale.ROOT, "%s at %.4g is not measured: %s", name, x, unmeasured.getMessage()));
        }
    }

    /** The same period with so many samples a side, linear between those that there are. */
    private static HeightMap resampled(HeightMap map, int side) {
        double[] heights = new double[side * side];
        for (int i = 0; i < heights.length; i++) {
            double x = (double) (i % side) * map.columns() / side;
            double y = Math.floor((double) i / side) * map.rows() / side;
            int column = (int) x;
            int row = (int) y;
            double right = x - column;
            double below = y - row;
            int next = (column + 1) % map.columns();
            int under = (row + 1) % map.rows();
            heights[i] = (1 - below) * ((1 - right) * map.at(column, row) + right * map.at(next, row))
                    + below * ((1 - right) * map.at(column, under) + right * map.at(next, under));
        }
        return new HeightMap(side, side, map.width() / side, map.height() / side, heights);
    }
}
