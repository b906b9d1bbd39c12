package sunbeam.precompute.method;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodSettings.GemForm;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/**
 * Grating formula of GPU Gems, chapter 8, for comparison only.
 *
 * @param spacing distance of the lines in meters; empty for the patch's width, if that is one period
 * @param orders number of orders on each side of the mirror's; empty for the form's
 */
public record GemMethod(
        Optional<Double> spacing, Optional<Integer> orders, GemForm form, GaussianArea area, FresnelFactor fresnel)
        implements Method {
    private static final int STAM_ORDERS = 8;
    // Widest patch that may be one period of a grating with visible colors, meters.
    private static final double WIDEST_PERIOD = 10e-6;

    public static final MethodType TYPE = new MethodType(
            "gem",
            "formula with a grating's spacing alone, for comparison only.",
            List.of(
                    MethodSettings.PRESET,
                    MethodSettings.SPACING,
                    MethodSettings.ORDERS,
                    MethodSettings.GEM_FORM,
                    MethodSettings.COHERENCE_LENGTH,
                    MethodSettings.FRESNEL),
            choices -> new GemMethod(
                    choices.find(MethodSettings.SPACING),
                    choices.find(MethodSettings.ORDERS),
                    choices.get(MethodSettings.GEM_FORM, Preset.isThesis(choices) ? GemForm.THESIS : GemForm.STAM),
                    GaussianArea.STANDARD.with(GaussianArea.windowOf(choices)),
                    FresnelFactor.of(choices)));

    @Override
    public MethodType type() {
        return TYPE;
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
                    MethodSettings.SPACING,
                    "is needed: a patch that is " + Lengths.format(width)
                            + " wide is more than one period; give the grating's, for example 1um");
        }
        double period = spacing.orElse(width);
        // The thesis's form has all orders that are visible at a |u| of up to 2.
        int visible = Math.max(1, (int) (2 * period / CieTable.MINIMUM_WAVELENGTH));
        int count = orders.orElse(form == GemForm.STAM ? STAM_ORDERS : visible);
        return new MethodPlan(
                "gem: lines " + Lengths.format(period) + " apart, " + count + (count == 1 ? " order" : " orders")
                        + " on each side, for comparison only",
                () -> List.of("the heights are not used"),
                Optional.empty(),
                Optional.empty(),
                new MemoryNeed(0, List.of()),
                // The formula has no power at a single wavelength.
                EnumSet.of(MethodUse.COLOR),
                () -> "gem|" + period + "|" + this,
                (use, sources) -> tables(period, count));
    }

    private ShaderTables tables(double period, int count) {
        ShaderTables.Builder tables = new ShaderTables.Builder("gem");
        Average.COHERENT.defineIn(tables);
        return fresnel.applyTo(tables.define("GEM_ORDERS", count)
                .define("THESIS_FORM", form == GemForm.THESIS ? 1 : 0)
                .reals("gemSpacing", period)
                .build(area.window()));
    }
}
