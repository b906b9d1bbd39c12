package sunbeam.app.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import sunbeam.app.cli.ColorReport.ViewColor;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.analysis.EnergyBalance;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;
import sunbeam.precompute.work.Progress;

/**
 * Colors of one surface in two viewing planes. Plane "along" is perpendicular to the lines of the grating or of the strongest wave, or
 * contains the patch's x axis if there is no wave; plane "across" is at right angles to it. Unless an azimuth is chosen, the light stands
 * in the viewing plane, so that each of two crossed gratings shows its colors in one plane.
 */
final class SurfaceColors {
    // Gauss-Legendre directions of a mean: these, and so many for each standard deviation of a sharp order at the
    // shortest wavelength. Wherever
    // an order lies, and a step's end cuts it, the mean errs by less than 2e-4 of the order's.
    private static final int FEWEST = 2;
    private static final double FOR_EACH_DEVIATION = 1.05;
    private static final int MOST_DIRECTIONS = 400_000;
    // Range of the purest color, relative to the first orders that verdicts name.
    private static final double WIDENED = 1.05;
    // Luminance, relative to a mirror's, below which no color is stated.
    private static final double FAINTEST = 1e-9;

    private final DiffractionSetup setup;
    private final Method method;
    private final RefractiveIndex index;
    private final List<Part> parts;
    private final GratingPeriod period;
    private final double turn;
    private final double azimuthDegrees;
    private final Optional<Double> lightAzimuthDegrees;
    private final double theta;
    private final List<ViewColor.View> views = new ArrayList<>();
    private final double[][] colors;
    private final CoherenceWindow window;
    private final double reach;
    private final int directions;
    private final GaussIntegrator rule;
    private final double angleStep;

    private record Part(ReflectionPart reflection, MethodPlan plan) {}

    /**
     * Plans the method for all views; the color at each viewing angle, in degrees, is the mean over a step.
     *
     * @param found the patch's period
     * @param light light's azimuth, by default that of each plane, and the patch's rotation
     * @param theta angle of the light to the normal, degrees
     */
    SurfaceColors(
            DiffractionSetup setup,
            GratingPeriod found,
            Choices choices,
            RefractiveIndex index,
            Choices light,
            double theta,
            Range angles) {
        window = GaussianArea.of(choices).window();
        angleStep = angles.step();
        directions = FEWEST
                + (int) Math.ceil(FOR_EACH_DEVIATION
                        * Math.toRadians(angles.step())
                        / window.sigmaOfOrder(CieTable.MINIMUM_WAVELENGTH));
        if (2L * directions * angles.count() > MOST_DIRECTIONS) {
            throw new UsageException(Text.format(
                    "--angles: %d angles of %d directions each, as light of a coherence length of %s needs, are too many;"
                            + " choose a part of them",
                    angles.count(), directions, Lengths.rounded(window.coherenceLength(), 3)));
        }
        rule = new GaussIntegratorFactory().legendre(directions);
        this.setup = setup;
        method = Methods.of(choices);
        this.index = index;
        this.theta = theta;
        turn = light.get(SceneSettings.ROTATE_PATCH);
        period = found.turned(turn);
        reach = window.mirrorReach(CieTable.MAXIMUM_WAVELENGTH, period.isSeen() ? period.period() : 0);
        azimuthDegrees = Math.toDegrees(period.hasWave() ? period.azimuth() : turn);
        lightAzimuthDegrees = light.find(LightOptions.PHI_I).map(Math::toDegrees);
        for (boolean along : new boolean[] {true, false}) {
            Arrays.stream(angles.values()).forEach(degrees -> views.add(view(along, degrees)));
        }
        colors = new double[views.size()][3];
        VisibleRange range = VisibleRange.of(
                views.stream().flatMap(view -> view.pairs().stream()).toList());
        parts = ReflectionPart.of(index, setup.cie(), method.fresnel().exponent()).stream()
                .map(part -> new Part(part, method.plan(setup.surface().withLight(part.cie()), range)))
                .toList();
    }

    private ViewColor.View view(boolean along, double thetaR) {
        double phi = azimuthDegrees + (along ? 0 : 90);
        double phiI = lightAzimuthDegrees.orElse(phi);
        Direction wi = Direction.ofDegrees(theta, phiI);
        List<DirectionPair> pairs = IntStream.range(0, directions)
                .mapToDouble(i -> thetaR + angleStep / 2 * rule.getPoint(i))
                .mapToObj(degrees -> Direction.ofDegrees(Math.abs(degrees), phi + (degrees < 0 ? 180 : 0)))
                .map(wr -> new DirectionPair(wi, wr).turned(-turn))
                .toList();
        return new ViewColor.View(along, phi, theta, phiI, thetaR, pairs);
    }

    Patch patch() {
        return setup.patch();
    }

    Optional<EnergyBalance> energy() {
        return EnergyBalance.largest(
                patch().scan(), index, views.get(0).pairs().get(0).wi());
    }

    MethodPlan plan() {
        return parts.get(0).plan;
    }

    void draw(RenderContext context) {
        List<DirectionQuery> queries = views.stream()
                .flatMap(view -> view.pairs().stream())
                .map(pair -> new DirectionQuery(pair, 0))
                .toList();
        for (Part part : parts) {
            List<float[]> powers = evaluate(context, part.plan, MethodUse.COLOR, queries);
            for (int i = 0; i < queries.size(); i++) {
                double gain = part.reflection.gain(queries.get(i).pair()) * rule.getWeight(i % directions) / 2;
                for (int c = 0; c < 3; c++) {
                    colors[i / directions][c] += gain * powers.get(i)[c];
                }
            }
        }
    }

    private List<float[]> evaluate(
            RenderContext context, MethodPlan plan, MethodUse use, List<DirectionQuery> queries) {
        // Progress of several surfaces appears on one line of the terminal, so it names the surface.
        String label = (use == MethodUse.SPECTRAL ? "Spectrum of " : "Colors of ") + patch().name();
        try (UploadedTables tables = UploadedTables.upload(context, setup.tables(plan, use));
                DirectionsRenderer renderer = new DirectionsRenderer(context, tables, use == MethodUse.SPECTRAL);
                Progress progress = setup.progress().start(label, queries.size())) {
            return renderer.evaluate(queries, progress::step);
        }
    }

    /** True if a color is the surface's own: bright enough and outside the gloss, which is a thousand times brighter than any order. */
    private boolean isColor(ViewColor.View view, double[] xyz) {
        return view.distances().getMin() > reach && xyz[1] >= FAINTEST;
    }

    /** True where the samples resolve what diffracts all visible light and, for a grating, where its first and second orders lie. */
    private boolean mayBePurest(ViewColor.View view) {
        HeightMap map = patch().heights();
        boolean resolved = view.pairs().stream()
                .allMatch(pair -> isResolved(pair.u(), map.pitchX(), map.columns())
                        && isResolved(pair.v(), map.pitchY(), map.rows()));
        if (!resolved || !period.isSeen()) {
            return resolved;
        }
        double[] others =
                period.others().stream().mapToDouble(SpatialFrequency::period).toArray();
        double shortest = period.isSure() ? period.low() : period.period();
        double longest = period.isSure() ? period.high() : period.period();
        double red = 2 * Verdict.RED / Arrays.stream(others).reduce(shortest, Math::min);
        double violet = Verdict.VIOLET / Arrays.stream(others).reduce(longest, Math::max);
        return (view.along() || others.length > 0)
                && view.distances().getMin() <= WIDENED * red
                && view.distances().getMax() >= violet / WIDENED;
    }

    private static boolean isResolved(double u, double pitch, int samples) {
        return samples == 1 || 2 * pitch * Math.abs(u) <= CieTable.MINIMUM_WAVELENGTH;
    }

    private List<double[]> outsideGloss() {
        return IntStream.range(0, views.size())
                .filter(i -> isColor(views.get(i), colors[i]))
                .mapToObj(i -> colors[i])
                .toList();
    }

    /** Returns the colors that set the exposure: those outside the gloss, or all if the surface has no color. */
    LinearPicture meteredColors() {
        List<double[]> some = isColored() ? outsideGloss() : List.of(colors);
        return new LinearPicture(some.size(), 1, Floats.of(3 * some.size(), i -> some.get(i / 3)[i % 3]));
    }

    /** Returns the verdict for this light. If no view has a color though the surface has, it says why. */
    private Verdict verdict() {
        Verdict verdict =
                Verdict.of(patch(), period, theta, lightAzimuthDegrees.orElse(azimuthDegrees) - azimuthDegrees);
        String why = views.stream().anyMatch(view -> view.distances().getMin() > reach)
                ? "No color is seen: the orders lie beside both planes (give no --phi-i) or beyond --angles"
                : "No color can be told: light that is coherent over only "
                        + Lengths.rounded(window.coherenceLength(), 3)
                        + ", as far as the scan or the light reaches, blurs every order into the gloss";
        return verdict.hasColor() && outsideGloss().isEmpty()
                ? new Verdict(verdict.code(), why, verdict.firstOrders())
                : verdict;
    }

    boolean isColored() {
        return verdict().hasColor() && !outsideGloss().isEmpty();
    }

    ColorReport report(RenderContext context, DisplayTransform display, double tolerance) {
        boolean colored = isColored();
        List<ViewColor> seen = IntStream.range(0, views.size())
                .mapToObj(i -> ViewColor.of(views.get(i), colors[i], display, tolerance, setup.cie()))
                .toList();
        List<ViewColor> outside = seen.stream()
                .filter(color -> colored && isColor(color.view(), color.xyz()))
                .toList();
        Optional<ViewColor> purest = ViewColor.purest(outside, this::mayBePurest);
        ViewColor.View chosen = purest.map(ViewColor::view).orElseGet(() -> view(true, -theta));
        ColorReport.Spectrum spectrum = spectrum(context, chosen);
        double length = window.coherenceLength();
        return new ColorReport(patch(), period, verdict(), colored, length, plan().summary(), seen, spectrum, purest);
    }

    private ColorReport.Spectrum spectrum(RenderContext context, ViewColor.View view) {
        double[] wavelengths = ColorReport.Spectrum.fineWavelengths();
        List<DirectionQuery> queries = Arrays.stream(wavelengths)
                .boxed()
                .flatMap(wavelength -> view.pairs().stream().map(pair -> new DirectionQuery(pair, wavelength)))
                .toList();
        Gain gain = ReflectionPart.gain(index, setup.cie(), method.fresnel().exponent());
        int column = setup.exact(method).ensemble() ? 1 : 0;
        List<float[]> powers = evaluate(context, plan(), MethodUse.SPECTRAL, queries);
        double[] radiances = new double[wavelengths.length];
        for (int i = 0; i < queries.size(); i++) {
            DirectionPair pair = view.pairs().get(i % directions);
            double factor = gain.relativeRadiance(pair, wavelengths[i / directions]);
            radiances[i / directions] += factor * powers.get(i)[column] * rule.getWeight(i % directions) / 2;
        }
        return ColorReport.Spectrum.of(view, radiances);
    }
}
