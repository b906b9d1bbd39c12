package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.colourtable.ColourSources;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;

/** What is seen of one surface along and across its direction of most colour. */
final class ColorStrips {
    /** Viewing angles to the normal, on either side. */
    static final int LARGEST_VIEW_DEGREES = 80;

    private final DiffractionSetup setup;
    private final Method method;
    private final List<ReflectionPart> parts;
    private final PrincipalDirection direction;
    private final double lightAzimuthDegrees;
    private final List<SeenColor.View> views = new ArrayList<>();
    private final List<SeenColor.View> candidates = new ArrayList<>();
    private final List<MethodPlan> plans = new ArrayList<>();
    private MirrorReach reach;

    /**
     * Lays out the directions and plans them.
     *
     * @param lightAzimuth degrees; empty for a light in the plane of the direction of most colour
     * @param thetas of the light, degrees
     * @param step of the viewing angle, degrees
     */
    ColorStrips(
            DiffractionSetup setup,
            Method method,
            RefractiveIndex index,
            OptionalDouble lightAzimuth,
            List<Double> thetas,
            double step) {
        this.setup = setup;
        this.method = method;
        this.parts = ReflectionPart.of(index, setup.cie());
        HeightMap heights = setup.patch().heights();
        this.direction = setup.patch().repetition() == Patch.Repetition.PERIODIC
                ? PrincipalDirection.ofPeriod(heights)
                : PrincipalDirection.of(heights);
        this.lightAzimuthDegrees = lightAzimuth.orElse(direction.azimuthDegrees());
        long each = Math.round(LARGEST_VIEW_DEGREES / step);
        for (boolean along : new boolean[] {true, false}) {
            for (double theta : thetas) {
                for (long i = -each; i <= each; i++) {
                    views.add(view(along, theta, rounded(i * step)));
                }
            }
        }
        for (int degrees = -LARGEST_VIEW_DEGREES; degrees <= LARGEST_VIEW_DEGREES; degrees++) {
            candidates.add(view(true, thetas.get(0), degrees));
        }
        VisibleRange range = VisibleRange.of(Stream.concat(views.stream(), candidates.stream())
                .map(SeenColor.View::pair)
                .toList());
        for (ReflectionPart part : parts) {
            plans.add(method.plan(setup.surface().under(part.cie()), range));
        }
    }

    /** Steps that are not powers of two leave rounding errors. */
    private static double rounded(double degrees) {
        return Math.rint(degrees * 1e9) / 1e9;
    }

    /** A place of a strip. */
    SeenColor.View view(boolean along, double thetaI, double thetaR) {
        double azimuth = direction.azimuthDegrees() + (along ? 0 : 90) + (thetaR < 0 ? 180 : 0);
        Direction wi = Direction.ofDegrees(thetaI, lightAzimuthDegrees);
        Direction wr = Direction.ofDegrees(Math.abs(thetaR), azimuth);
        return new SeenColor.View(along, thetaI, thetaR, new DirectionPair(wi, wr));
    }

    DiffractionSetup setup() {
        return setup;
    }

    MethodPlan plan() {
        return plans.get(0);
    }

    /** Of most colour: that of the strip along. */
    PrincipalDirection direction() {
        return direction;
    }

    double lightAzimuthDegrees() {
        return lightAzimuthDegrees;
    }

    List<SeenColor.View> views() {
        return views;
    }

    /** Every degree along, under the first light, whatever the strips' step: among them is the purest colour. */
    List<SeenColor.View> candidates() {
        return candidates;
    }

    /** Of the mirror's light under the window that was drawn with; known after {@link #colours}. */
    MirrorReach reach() {
        return reach;
    }

    /**
     * X, Y, Z of the relative radiance.
     *
     * @param shown for each view
     * @param candidates for each candidate
     */
    record Colours(List<double[]> shown, List<double[]> candidates) {}

    /** What is seen. */
    Colours colours(RenderContext context) {
        List<SeenColor.View> all =
                Stream.concat(views.stream(), candidates.stream()).distinct().toList();
        List<double[]> colours = colours(context, all);
        Map<SeenColor.View, double[]> byView = new HashMap<>();
        for (int i = 0; i < all.size(); i++) {
            byView.put(all.get(i), colours.get(i));
        }
        return new Colours(
                views.stream().map(byView::get).toList(),
                candidates.stream().map(byView::get).toList());
    }

    private List<double[]> colours(RenderContext context, List<SeenColor.View> all) {
        List<Query> queries =
                all.stream().map(view -> new Query(view.pair(), 0)).toList();
        List<double[]> sums = new ArrayList<>();
        all.forEach(view -> sums.add(new double[3]));
        for (int p = 0; p < parts.size(); p++) {
            List<float[]> powers = evaluate(context, p, MethodUse.COLOUR, queries);
            for (int i = 0; i < queries.size(); i++) {
                double gain = parts.get(p).gain(all.get(i).pair());
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

    /** Whose progress is shown, and of what: several surfaces follow each other. */
    static String label(String surface, MethodUse use) {
        return (use == MethodUse.SPECTRAL ? "Spectrum of " : "Colours of ") + surface;
    }

    private List<float[]> evaluate(RenderContext context, int part, MethodUse use, List<Query> queries) {
        String label = label(setup.patch().name(), use);
        ColourSources colours = (tables, places) -> GpuColours.of(label, tables, places);
        try (UploadedTables tables = UploadedTables.upload(context, setup.tables(plans.get(part), use, colours));
                DirectionsRenderer renderer = new DirectionsRenderer(context, tables, use == MethodUse.SPECTRAL);
                Progress progress = Progress.start(label, queries.size())) {
            reach = new MirrorReach(new CoherenceWindow(tables.windowSigma()));
            return renderer.evaluate(queries, progress::step);
        }
    }
}
