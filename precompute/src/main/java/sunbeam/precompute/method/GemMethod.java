package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.FRESNEL;
import static sunbeam.precompute.plan.MethodSettings.ORDERS;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.SPACING;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.units.Lengths;

/**
 * Grating formula of GPU Gems, chapter 8, which uses only a spacing of the surface; for comparison only.
 *
 * @param spacing distance of the lines in meters; empty for the patch's width, if that is one period
 * @param orders number of orders on each side of the mirror's
 */
public record GemMethod(Optional<Double> spacing, int orders, CoherenceWindow window, FresnelFactor fresnel)
        implements Method {
    private static final int GEM_ORDERS = 8;
    private static final int THESIS_ORDERS = 1;

    // Widest patch that may be one period of a grating with visible colors, meters.
    private static final double WIDEST_PERIOD = 10e-6;

    public static final MethodType TYPE = new MethodType(
            "gem",
            "a grating's spacing alone, for comparison only.",
            List.of(PRESET, SPACING, ORDERS, COHERENCE_LENGTH, FRESNEL),
            choices -> new GemMethod(
                    choices.find(SPACING),
                    choices.get(ORDERS, Preset.isThesis(choices) ? THESIS_ORDERS : GEM_ORDERS),
                    GaussianArea.windowOf(choices),
                    FresnelFactor.of(choices)));

    public GemMethod {
        spacing.ifPresent(SPACING.kind()::check);
        ORDERS.kind().check(orders);
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod referenceMethod(HeightMap map) {
        return new ReferenceMethod(GaussianArea.STANDARD.with(window));
    }

    @Override
    public boolean isNormalizedToMirror() {
        return false;
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        surface.requireSmoothLight();
        double width = surface.map().width();
        if (spacing.isEmpty() && width > WIDEST_PERIOD) {
            throw new SettingException(
                    SPACING,
                    "is needed: a patch that is " + Lengths.format(width)
                            + " wide is no single period; give the grating's, for example 1um");
        }
        double period = spacing.orElse(width);
        return new MethodPlan(
                "gem: lines " + Lengths.format(period) + " apart, " + orders + (orders == 1 ? " order" : " orders")
                        + " on each side, for comparison only",
                () -> List.of("nothing of the surface is used"),
                Optional.empty(),
                false,
                Optional.empty(),
                MemoryNeed.of(0, List.of()),
                // The formula has no power at a single wavelength.
                EnumSet.of(MethodUse.COLOR),
                () -> String.join("|", "gem", Double.toString(period), toString()),
                (use, sources) -> tables(period));
    }

    private ShaderTables tables(double period) {
        ShaderTables.Builder tables = new ShaderTables.Builder("gem");
        Average.COHERENT.defineIn(tables);
        return fresnel.applyTo(tables.define("GEM_ORDERS", orders)
                .reals("gemSpacing", period)
                .build(window.sigmaMeters(), window.specularReach(CieTable.MAXIMUM_WAVELENGTH)));
    }
}
