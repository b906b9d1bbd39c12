package sunbeam.precompute.method;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Method {@code full}: sums power over all wavelengths, with a planned sampling or the thesis's, under a Gaussian window. */
public record FullMethod(TableChoices table, GaussianArea area, FresnelFactor fresnel) implements Method {
    static final List<Setting<?>> SETTINGS = Setting.union(
            TableChoices.SETTINGS,
            List.of(MethodSettings.RADIUS, MethodSettings.ANCHOR),
            GaussianArea.SETTINGS,
            List.of(MethodSettings.FRESNEL));

    public static final MethodType TYPE =
            new MethodType("full", "all wavelengths, Gaussian coherence window.", SETTINGS, FullMethod::of);

    public static FullMethod of(Choices choices) {
        return new FullMethod(new TableChoices(choices), GaussianArea.of(choices), FresnelFactor.of(choices));
    }

    public static FullMethod thesis() {
        return of(Choices.none().with(MethodSettings.PRESET, Preset.THESIS));
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        return planned(surface, tablePlan(surface, range), fresnel);
    }

    static MethodPlan planned(Surface surface, SpectrumPlan plan, FresnelFactor fresnel) {
        return new MethodPlan(
                plan.summary() + ", " + plan.steps(),
                plan::reasons,
                Optional.of(plan),
                Optional.empty(),
                MemoryNeed.of(plan, surface.map().rows()),
                EnumSet.allOf(MethodUse.class),
                () -> "full|" + surface.key() + "|" + plan.key() + "|" + fresnel,
                (use, sources) -> fresnel.applyTo(plan.tables(sources.fourier(plan), use, surface.cie())));
    }

    public SpectrumPlan tablePlan(Surface surface, VisibleRange range) {
        return surface.planner().plan(table, area, range);
    }
}
