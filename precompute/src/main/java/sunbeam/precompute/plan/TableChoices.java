package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * What a user fixes of Fourier tables and the wavelengths at which they are read; the planner chooses the rest.
 *
 * @param accuracy what it chooses for
 * @param expansion kind of expansion
 * @param terms number of its terms
 * @param wavelengthStep of equal steps, metres
 */
public record TableChoices(
        Accuracy accuracy, Optional<ExpansionKind> expansion, OptionalInt terms, OptionalDouble wavelengthStep) {
    /** The settings that these come from. */
    public static final List<Setting<?>> SETTINGS =
            List.of(MethodSettings.PRESET, MethodSettings.TOLERANCE, EXPANSION, TERMS, WAVELENGTH_STEP);

    public TableChoices {
        terms.ifPresent(TERMS.kind()::check);
        wavelengthStep.ifPresent(WAVELENGTH_STEP.kind()::check);
    }

    /** Nothing fixed. */
    public static TableChoices of(Accuracy accuracy) {
        return new TableChoices(accuracy, Optional.empty(), OptionalInt.empty(), OptionalDouble.empty());
    }

    /** As chosen. */
    public static TableChoices of(Choices choices) {
        return new TableChoices(
                Accuracy.of(choices),
                choices.find(EXPANSION),
                choices.find(TERMS).map(OptionalInt::of).orElseGet(OptionalInt::empty),
                choices.find(WAVELENGTH_STEP).map(OptionalDouble::of).orElseGet(OptionalDouble::empty));
    }

    /** The same with an expansion of so many terms. */
    public TableChoices withExpansion(ExpansionKind kind, int count) {
        return new TableChoices(accuracy, Optional.of(kind), OptionalInt.of(count), wavelengthStep);
    }

    /** The same at wavelengths so far apart, metres. */
    public TableChoices withWavelengthStep(double metres) {
        return new TableChoices(accuracy, expansion, terms, OptionalDouble.of(metres));
    }
}
