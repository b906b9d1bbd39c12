package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.colortable.ColorSources;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;

/** What is seen of one surface in two planes, along and across the direction in which it spreads most color. */
final class StripColors {
    /** Viewing angles to the normal, on either side. */
    static final int LARGEST_VIEW_DEGREES = 80;

    private final DiffractionSetup setup;
    private final Method method;
    private final SurfaceOrder order;
    private final List<ReflectionPart> parts;
    private final double lightAzimuthDegrees;
    private final List<SeenColor.View> views = new ArrayList<>();
    private final List<MethodPlan> plans = new ArrayList<>();
    private Gloss gloss;

    /**
     * Lays out the directions and plans them.
     *
     * @param lightAzimuth degrees; empty for a light in the plane along
     * @param thetas of the light, degrees
     * @param step of the viewing angle, degrees
     */
    StripColors(
            DiffractionSetup setup,
            Method method,
            RefractiveIndex index,
            OptionalDouble lightAzimuth,
            List<Double> thetas,
            double step) {
        this.setup = setup;
        this.method = method;
        this.parts = ReflectionPart.of(index, setup.cie());
        this.order = SurfaceOrder.of(setup.patch());
        this.lightAzimuthDegrees = lightAzimuth.orElse(order.plane().azimuthDegrees());
        long each = Math.round(LARGEST_VIEW_DEGREES / step);
        for (boolean along : new boolean[] {true, false}) {
            for (double theta : thetas) {
                for (long i = -each; i <= each; i++) {
                    // Steps that are not powers of two leave rounding errors.
                    views.add(view(along, theta, Math.rint(i * step * 1e9) / 1e9));
                }
            }
        }
        VisibleRange range =
                VisibleRange.of(views.stream().map(SeenColor.View::pair).toList());
        for (ReflectionPart part : parts) {
            plans.add(method.plan(setup.surface().under(part.cie()), range));
        }
    }

    /** A place of a strip. */
    SeenColor.View view(boolean along, double thetaI, double thetaR) {
        double azimuth = order.plane().azimuthDegrees() + (along ? 0 : 90) + (thetaR < 0 ? 180 : 0);
        Direction wr = Direction.ofDegrees(Math.abs(thetaR), azimuth);
        return new SeenColor.View(along, thetaI, thetaR, new DirectionPair(light(thetaI), wr));
    }

    /** Towards the light. */
    Direction light(double thetaI) {
        return Direction.ofDegrees(thetaI, lightAzimuthDegrees);
    }

    DiffractionSetup setup() {
        return setup;
    }

    SurfaceOrder order() {
        return order;
    }

    MethodPlan plan() {
        return plans.get(0);
    }

    double lightAzimuthDegrees() {
        return lightAzimuthDegrees;
    }

    /** Strip by strip, along first; in a strip light by light; by viewing angle. */
    List<SeenColor.View> views() {
        return views;
    }

    /** Of the window that was drawn with; known after {@link #colors}. */
    Gloss gloss() {
        return gloss;
    }

    /** X, Y, Z of the relative radiance for each view. */
    List<double[]> colors(RenderContext context) {
        List<Query> queries =
                views.stream().map(view -> new Query(view.pair(), 0)).toList();
        List<double[]> sums = new ArrayList<>();
        views.forEach(view -> sums.add(new double[3]));
        for (int p = 0; p < parts.size(); p++) {
            List<float[]> powers = evaluate(context, p, MethodUse.COLOR, queries);
            for (int i = 0; i < queries.size(); i++) {
                double gain = parts.get(p).gain(views.get(i).pair());
                for (int c = 0; c < 3; c++) {
                    sums.get(i)[c] += gain * powers.get(i)[c];
                }
            }
        }
        return sums;
    }

    /**
     * Relative radiance by wavelength.
     *
     * @param wavelengths metres
     * @return one array a view
     */
    List<double[]> spectra(
            RenderContext context, List<SeenColor.View> chosen, double[] wavelengths, RefractiveIndex index) {
        List<Query> queries = new ArrayList<>();
        for (SeenColor.View view : chosen) {
            for (double wavelength : wavelengths) {
                queries.add(new Query(view.pair(), wavelength));
            }
        }
        ReflectionPart unit = new ReflectionPart(setup.cie(), 1, 0);
        ReflectionPart grazing = new ReflectionPart(setup.cie(), 0, 1);
        double mirror = ReflectionPart.mirror(index, setup.cie());
        int column = setup.exact(method).ensemble() ? 1 : 0;
        List<float[]> powers = evaluate(context, 0, MethodUse.SPECTRAL, queries);
        List<double[]> spectra = new ArrayList<>();
        for (int v = 0; v < chosen.size(); v++) {
            DirectionPair pair = chosen.get(v).pair();
            double[] spectrum = new double[wavelengths.length];
            for (int i = 0; i < spectrum.length; i++) {
                float[] power = powers.get(v * wavelengths.length + i);
                double normal = index.reflectance(wavelengths[i]);
                double reflected = normal * unit.gain(pair) + (1 - normal) * grazing.gain(pair);
                spectrum[i] = reflected / mirror * power[column];
            }
            spectra.add(spectrum);
        }
        return spectra;
    }

    private List<float[]> evaluate(RenderContext context, int part, MethodUse use, List<Query> queries) {
        // Several surfaces follow each other on one line of a terminal.
        String label = (use == MethodUse.SPECTRAL ? "Spectrum of " : "Colors of ")
                + setup.patch().name();
        ColorSources sources = (tables, places) -> GpuColors.of(label, tables, places);
        try (UploadedTables tables = UploadedTables.upload(context, setup.tables(plans.get(part), use, sources));
                DirectionsRenderer renderer = new DirectionsRenderer(context, tables, use == MethodUse.SPECTRAL);
                Progress progress = Progress.start(label, queries.size())) {
            gloss = new Gloss(new CoherenceWindow(tables.windowSigma()));
            return renderer.evaluate(queries, progress::step);
        }
    }
}
