package sunbeam.app.measure.performance;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import jrtr.GraphicsException;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.colourtable.TableDesign;
import sunbeam.precompute.colourtable.TablePages;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.SettingException;

/** Measures how the cost of {@code full}, {@code table} and the thesis's shader grows. */
final class GrowthExperiment {
    private static final String TABLE = "table";
    private static final String FULL = "full";
    private static final String THESIS = "full, thesis";

    private final Meter meter;
    private final Scale scale;
    private final Environment environment;
    private final Patch base;
    private final List<Growth.Point> points = new ArrayList<>();
    private final List<String> remarks = new ArrayList<>();

    /** @param base the surface that is drawn, resampled and stretched */
    GrowthExperiment(Meter meter, Scale scale, Environment environment, Patch base) {
        this.meter = meter;
        this.scale = scale;
        this.environment = environment;
        this.base = base;
    }

    /** Along all axes. */
    List<Growth> run() {
        return List.of(pixels(), samples(), relief(), coherence());
    }

    private Growth pixels() {
        begin();
        DiffractionSetup setup = setup(base.heights());
        List<Method> methods = List.of(FullMethod.thesis(), full(scale.area()), table(scale.area()));
        List<String> names = List.of(THESIS, FULL, TABLE);
        for (int i = 0; i < methods.size(); i++) {
            double perPixel = 0;
            for (int size : scale.sizes()) {
                // A frame for warming up, and those that are timed; three quarters of the square are disc.
                double expected = perPixel * 1e-6 * 0.785 * size * size * (1 + meter.frames());
                if (expected > scale.budgetSeconds()) {
                    remarks.add(String.format(
                            Locale.ROOT, "%s at %d pixels would take %.0f s", names.get(i), size, expected));
                    continue;
                }
                Optional<Measured> measured = add(size, names.get(i), meter.of(size), setup, methods.get(i));
                perPixel = measured.map(Measured::microseconds).orElse(perPixel);
            }
        }
        return end("pixels", "pixels of a map", "width and height of the map / pixels");
    }

    private Growth samples() {
        begin();
        for (int side : scale.samples()) {
            both(side, resampled(base.heights(), side), scale.area());
        }
        return end("samples", "samples of the patch", "samples along a side of the patch");
    }

    private Growth relief() {
        begin();
        for (double relief : scale.reliefs()) {
            double factor = relief / base.heights().relief();
            both(relief * 1e6, base.heights().map(height -> factor * height), scale.area());
        }
        return end("relief", "relief", "relief / um");
    }

    private Growth coherence() {
        begin();
        for (double length : scale.lengths()) {
            both(length * 1e6, base.heights(), scale.area().with(CoherenceWindow.ofCoherenceLength(length)));
        }
        return end("coherence", "coherence length", "coherence length / um");
    }

    private void begin() {
        points.clear();
        remarks.clear();
    }

    private Growth end(String key, String title, String axis) {
        return new Growth(key, base.name() + ": cost over " + title, axis, points, remarks);
    }

    private void both(double x, HeightMap heights, GaussianArea area) {
        DiffractionSetup setup = setup(heights);
        Optional<Measured> full = add(x, FULL, meter, setup, full(area));
        TablePages pages =
                TablePages.of(TableDesign.within(scale.growthTolerance(), area, heights.relief()), Meter.LIGHT);
        double expected = full.map(measured -> measured.microseconds() * 1e-6 * pages.evaluated())
                .orElse(0.0);
        if (expected > scale.budgetSeconds()) {
            remarks.add(String.format(
                    Locale.ROOT,
                    "table at %.3g has %.1f million places; at full's time per pixel, baking them takes %.0f s",
                    x,
                    pages.evaluated() * 1e-6,
                    expected));
        } else {
            add(x, TABLE, meter, setup, table(area));
        }
    }

    private Optional<Measured> add(double x, String name, Meter sized, DiffractionSetup setup, Method method) {
        try {
            Measured measured = sized.measure(setup, name, method, Optional.empty(), "");
            points.add(new Growth.Point(x, name, measured));
            return Optional.of(measured);
        } catch (GraphicsException | SettingException unmeasured) {
            remarks.add(
                    String.format(Locale.ROOT, "%s at %.4g was not measured: %s", name, x, unmeasured.getMessage()));
            return Optional.empty();
        }
    }

    private DiffractionSetup setup(HeightMap heights) {
        return new DiffractionSetup(
                new Patch(base.name(), heights, base.source(), List.of()), environment, warning -> {});
    }

    private Method full(GaussianArea area) {
        return FullMethod.within(scale.growthTolerance()).with(area);
    }

    private Method table(GaussianArea area) {
        return new TableMethod(scale.growthTolerance(), area);
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
