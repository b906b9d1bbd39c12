package sunbeam.app.measure.errors;

import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.INTERPOLATION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.cause.ErrorSource;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** What may help where a tolerance is missed, the least first. */
final class Remedies {
    private static final List<Setting<?>> OVERRIDES =
            List.of(PRESET, EXPANSION, TERMS, RADIUS, ANCHOR, WAVELENGTH_STEP);
    private static final double[] FINER = {1 / 3.0, 0.1, 0.01};
    // For a method whose wavelengths do not follow from the tolerance, metres.
    private static final double[] STEPS = {1e-9, 0.2e-9, 0.05e-9};

    private final Choices choices;
    private final Method method;
    private final double tolerance;
    private final List<Remedy> all = new ArrayList<>();

    private Remedies(Choices choices, Method method, double tolerance) {
        this.choices = choices;
        this.method = method;
        this.tolerance = tolerance;
    }

    /**
     * What may help.
     *
     * @param choices that the result was made with
     * @param method the same
     * @param source that errs most, where it is known
     * @param tolerance that was missed
     */
    static List<Remedy> of(Choices choices, Method method, Optional<ErrorSource> source, double tolerance) {
        return new Remedies(choices, method, tolerance).list(source);
    }

    private List<Remedy> list(Optional<ErrorSource> source) {
        List<Setting<?>> chosen = chosen(OVERRIDES);
        List<Setting<?>> guilty =
                source.map(Remedies::overriding).map(this::chosen).orElse(List.of());
        if (!guilty.isEmpty()) {
            all.add(leavingOut(guilty));
        }
        if (!chosen.isEmpty() && !chosen.equals(guilty)) {
            all.add(leavingOut(chosen));
        }
        method.instead()
                .ifPresent(other -> all.add(
                        new Remedy(new Words().give(METHOD, other.label()).sentence(), choices.with(METHOD, other))));
        // The least that was left out, so that no more is advised than helps.
        addOwn(chosen.isEmpty() ? new Remedy(new Words().sentence(), choices) : leavingOut(chosen));
        return all;
    }

    /** What only some methods have. */
    private void addOwn(Remedy planned) {
        if (method.type().has(INTERPOLATION)) {
            boolean linear = choices.get(INTERPOLATION) == PeriodInterpolation.LINEAR;
            Remedy between = linear ? and(planned, INTERPOLATION, PeriodInterpolation.SINC) : planned;
            if (linear) {
                all.add(between);
            }
            for (double step : STEPS) {
                all.add(and(between, WAVELENGTH_STEP, step));
            }
        }
        if (!method.type().has(TOLERANCE)) {
            return;
        }
        for (double factor : FINER) {
            double finer = BigDecimal.valueOf(factor * tolerance)
                    .round(new MathContext(1, RoundingMode.HALF_EVEN))
                    .doubleValue();
            if (finer >= ErrorBudget.FINEST) {
                all.add(and(planned, TOLERANCE, finer));
            }
        }
    }

    private static <T> Remedy and(Remedy remedy, Setting<T> setting, T value) {
        Choices changed = remedy.choices().with(setting, value);
        Words words =
                new Words(remedy.words()).give(setting, changed.written(setting).replace(" ", ""));
        return new Remedy(words.sentence(), changed);
    }

    private List<Setting<?>> chosen(List<Setting<?>> settings) {
        return settings.stream().filter(this::overrides).toList();
    }

    private boolean overrides(Setting<?> setting) {
        return choices.has(setting)
                && !(setting.equals(PRESET) && choices.get(PRESET, Preset.NONE) == Preset.NONE)
                && method.type().has(setting);
    }

    private static List<Setting<?>> overriding(ErrorSource source) {
        return switch (source) {
            case EXPANSION, FLOAT32 -> List.of(EXPANSION, TERMS);
            case WINDOW -> List.of(RADIUS, ANCHOR);
            // A radius that is fixed fixes the wavelengths' kind, too.
            case WAVELENGTHS -> List.of(RADIUS, ANCHOR, WAVELENGTH_STEP);
            case CROP -> List.of();
        };
    }

    private Remedy leavingOut(List<Setting<?>> settings) {
        Choices rest = choices.without(settings);
        Words words = new Words().leaveOut(settings);
        if (settings.contains(PRESET) && method.type().has(WINDOW_ORIGIN) && !choices.has(WINDOW_ORIGIN)) {
            // The preset has it there; elsewhere another part of the surface is seen.
            return new Remedy(
                    words.give(WINDOW_ORIGIN, "corner").sentence(), rest.with(WINDOW_ORIGIN, WindowOrigin.CORNER));
        }
        return new Remedy(words.sentence(), rest);
    }
}
