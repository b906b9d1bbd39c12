package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.units.Lengths;

/**
 * Sums a neighborhood of bins at fixed wavelengths: the thesis's way (shaders/method/full_bins.glsl).
 *
 * @param neighborhood the bins
 * @param wavelengths in equal steps
 */
public record BinSampling(Neighborhood neighborhood, WavelengthNodes wavelengths) implements Sampling {
    private static final Neighborhood THESIS_NEIGHBORHOOD = new Neighborhood(1, Neighborhood.Anchor.FLOOR);
    private static final double THESIS_WAVELENGTH_STEP = 5e-9;
    // Metres: fine enough for the color matching functions, and for textures' longest side.
    private static final double COARSEST_WAVELENGTH_STEP = 1e-9;
    private static final double FINEST_WAVELENGTH_STEP = 0.05e-9;

    /** What is fixed; the rest is the thesis's with its preset, else planned. */
    static BinSampling of(TableChoices table, CoherenceWindow window, VisibleRange range, HeightMap map, CieTable cie) {
        boolean thesis = table.accuracy().isThesis();
        double planned = coarsestWavelengthStep(window, range, table.tolerance());
        double step = thesis
                ? THESIS_WAVELENGTH_STEP
                : Math.max(FINEST_WAVELENGTH_STEP, Math.min(COARSEST_WAVELENGTH_STEP, planned));
        return new BinSampling(
                table.neighborhood().orElseGet(() -> thesis ? THESIS_NEIGHBORHOOD : neighborhood(table, window, map)),
                WavelengthNodes.uniform(cie, table.wavelengthStep().orElse(step)));
    }

    private static Neighborhood neighborhood(TableChoices table, CoherenceWindow window, HeightMap map) {
        double sigmaBins = sigmaBins(window, map);
        int radius = new ErrorBudget(table.tolerance()).neighborhoodRadius(sigmaBins);
        PlanChecks.checkRadius(radius, window, sigmaBins);
        return new Neighborhood(radius, Neighborhood.Anchor.NEAREST);
    }

    private static double sigmaBins(CoherenceWindow window, HeightMap map) {
        return window.sigmaFrequency() * Math.max(map.width(), map.height());
    }

    @Override
    public String summary(VisibleRange range) {
        return neighborhood.summary() + " at " + wavelengths.count() + " wavelengths";
    }

    @Override
    public List<Sentence> warnings(Plan plan, double tolerance, HeightMap map) {
        List<Sentence> lines = new ArrayList<>();
        checkRadius(plan, tolerance, map, lines);
        checkWavelengths(plan, tolerance, lines);
        return lines;
    }

    private void checkRadius(Plan plan, double tolerance, HeightMap map, List<Sentence> lines) {
        double sigmaBins = sigmaBins(plan.window(), map);
        int needed = new ErrorBudget(tolerance).neighborhoodRadius(sigmaBins);
        if (neighborhood.radiusX() < needed) {
            lines.add(Sentence.of(
                    String.format(
                            Locale.ROOT,
                            "radius %d cuts the window's spectrum, which is %.2f DFT bins wide; the tolerance %s takes ",
                            neighborhood.radiusX(),
                            sigmaBins,
                            tolerance),
                    RADIUS,
                    " " + needed));
        }
    }

    private void checkWavelengths(Plan plan, double tolerance, List<Sentence> lines) {
        double step = (CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) / (wavelengths.count() - 1);
        double needed = coarsestWavelengthStep(plan.window(), plan.range(), tolerance);
        // 1e-9: a step that was planned comes back by way of a count.
        if (step > needed * (1 + 1e-9)) {
            lines.add(Sentence.of(
                    String.format(
                            Locale.ROOT,
                            "wavelengths %s apart miss parts of the orders farthest from the specular direction; the"
                                    + " tolerance %s takes ",
                            Lengths.format(step),
                            tolerance),
                    WAVELENGTH_STEP,
                    " " + Lengths.format(roundedDown(needed)).replace(" ", "")));
        }
    }

    /**
     * The coarsest step of the wavelength that keeps a tolerance, metres. The power of a lone order is a Gaussian of
     * deviation lambda^2 sigma_f / (sqrt(2) |(u, v)|), for which the trapezoid rule errs by 2 exp(-2 (pi deviation /
     * step)^2).
     */
    private static double coarsestWavelengthStep(CoherenceWindow window, VisibleRange range, double tolerance) {
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        double deviation =
                shortest * shortest * window.sigmaFrequency() / (Math.sqrt(2) * Math.max(1e-9, range.longestUv()));
        return Math.PI * deviation * Math.sqrt(2 / Math.log(2 / tolerance));
    }

    private static double roundedDown(double value) {
        return new BigDecimal(value)
                .round(new MathContext(2, RoundingMode.DOWN))
                .doubleValue();
    }

    @Override
    public int marginX(CoherenceWindow window, double width) {
        return neighborhood.marginX();
    }

    @Override
    public int marginY(CoherenceWindow window, double height) {
        return neighborhood.marginY();
    }

    @Override
    public long loopSteps(Plan plan) {
        return wavelengths.count() * neighborhood.loopSteps();
    }

    @Override
    public List<ArrayLayout> layouts(Plan plan, MethodUse use) {
        List<ArrayLayout> layouts = BinArrays.layouts(plan);
        layouts.add(ColorArrays.wavelengthsLayout(wavelengths));
        return layouts;
    }

    @Override
    public ShaderTables tables(Plan plan, FourierTable table, MethodUse use, CieTable cie) {
        return BinArrays.tables("full_bins", plan, table, neighborhood)
                .array(ColorArrays.wavelengths(wavelengths))
                .integers("wavelengthCount", wavelengths.count())
                .build(plan.window().sigmaMetres(), plan.specularReach());
    }

    /** For keys: the wavelengths follow from their number. */
    @Override
    public String toString() {
        return "BinSampling[" + neighborhood + ", " + wavelengths.count() + " wavelengths]";
    }
}
