package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.spectrum.Expansion;

/**
 * User's choices for Fourier tables, summed bins and wavelengths; the planner makes the others.
 *
 * @param promisedTolerance relative error, {@link ErrorBudget#FINEST}..{@link ErrorBudget#COARSEST}; empty for the thesis's choices, which
 *     promise nothing
 * @param neighborhood bins summed around each frequency, with the thesis's preset only
 * @param wavelengthStep equal step of the wavelength, meters
 */
public record TableChoices(
        Optional<Double> promisedTolerance,
        Optional<Expansion.Kind> expansion,
        Optional<Integer> terms,
        Optional<Neighborhood> neighborhood,
        Optional<Double> wavelengthStep) {
    /** Settings of these choices, except the neighborhood's, which not all methods have. */
    public static final List<Setting<?>> SETTINGS = List.of(PRESET, TOLERANCE, EXPANSION, TERMS, WAVELENGTH_STEP);

    private static final Neighborhood THESIS_BINS = new Neighborhood(1, Neighborhood.Anchor.FLOOR);

    public static final TableChoices THESIS = new TableChoices(
            Optional.empty(), Optional.empty(), Optional.empty(), Optional.of(THESIS_BINS), Optional.empty());

    public TableChoices {
        promisedTolerance.ifPresent(TOLERANCE.kind()::check);
        terms.ifPresent(TERMS.kind()::check);
        wavelengthStep.ifPresent(WAVELENGTH_STEP.kind()::check);
    }

    public static TableChoices within(double tolerance) {
        return new TableChoices(
                Optional.of(tolerance), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** Reads the choices; throws SettingException if they contradict each other. */
    public static TableChoices of(Choices choices) {
        boolean thesis = Preset.isThesis(choices);
        if (thesis && choices.has(TOLERANCE)) {
            throw choices.complaint(
                    TOLERANCE,
                    "contradicts ",
                    PRESET,
                    " " + choices.written(PRESET) + ", whose choices keep no tolerance; leave one of them out");
        }
        return new TableChoices(
                thesis ? Optional.empty() : Optional.of(choices.get(TOLERANCE)),
                choices.find(EXPANSION),
                choices.find(TERMS),
                neighborhood(choices, thesis),
                choices.find(WAVELENGTH_STEP));
    }

    private static Optional<Neighborhood> neighborhood(Choices choices, boolean thesis) {
        if (thesis) {
            return Optional.of(new Neighborhood(
                    choices.get(RADIUS, THESIS_BINS.radiusX()), choices.get(ANCHOR, Neighborhood.Anchor.FLOOR)));
        }
        for (Setting<?> setting : List.of(RADIUS, ANCHOR)) {
            if (choices.has(setting)) {
                throw choices.complaint(
                        setting,
                        "is of the thesis's bins, which a plan for a tolerance does not sum; leave it out, or give ",
                        PRESET,
                        " thesis");
            }
        }
        return Optional.empty();
    }

    public boolean isThesis() {
        return promisedTolerance.isEmpty();
    }

    public boolean fixesBins() {
        return neighborhood.isPresent() || wavelengthStep.isPresent();
    }

    double tolerance() {
        return promisedTolerance.orElse(ErrorBudget.STANDARD);
    }

    public TableChoices withWavelengthStep(double meters) {
        return new TableChoices(promisedTolerance, expansion, terms, neighborhood, Optional.of(meters));
    }
}
