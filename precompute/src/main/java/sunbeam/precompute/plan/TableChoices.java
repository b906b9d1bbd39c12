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

/** User's choices for Fourier tables, summed bins and wavelengths; the planner makes the others. */
public record TableChoices(Choices choices) {
    /** Settings of these choices, except the neighborhood's, which not all methods have. */
    public static final List<Setting<?>> SETTINGS = List.of(PRESET, TOLERANCE, EXPANSION, TERMS, WAVELENGTH_STEP);

    private static final List<Setting<?>> BINS = List.of(RADIUS, ANCHOR);
    public static final TableChoices THESIS = new TableChoices(Choices.none().with(PRESET, Preset.THESIS));

    /** Ignores settings of others; throws SettingException if the choices contradict each other. */
    public TableChoices {
        choices = choices.only(Setting.union(SETTINGS, BINS));
        boolean thesis = Preset.isThesis(choices);
        if (thesis && choices.has(TOLERANCE)) {
            throw choices.complaint(
                    TOLERANCE,
                    "contradicts ",
                    PRESET,
                    " " + choices.written(PRESET) + ", whose choices keep no tolerance; leave one of them out");
        }
        for (Setting<?> setting : BINS) {
            if (!thesis && choices.has(setting)) {
                throw choices.complaint(
                        setting,
                        "is of the thesis's bins, which a plan for a tolerance does not sum; leave it out, or give ",
                        PRESET,
                        " thesis");
            }
        }
        choices = thesis ? choices : choices.without(PRESET).orStandard(TOLERANCE);
    }

    public static TableChoices within(double tolerance) {
        return new TableChoices(Choices.none().with(TOLERANCE, tolerance));
    }

    public boolean isThesis() {
        return Preset.isThesis(choices);
    }

    /** Returns the relative error; empty for the thesis's choices, which promise nothing. */
    Optional<Double> promisedTolerance() {
        return choices.find(TOLERANCE);
    }

    double tolerance() {
        return choices.get(TOLERANCE);
    }

    /** Returns the bins summed around each frequency; empty except for the thesis's choices. */
    public Optional<Neighborhood> neighborhood() {
        return isThesis()
                ? Optional.of(new Neighborhood(choices.get(RADIUS, 1), choices.get(ANCHOR, Neighborhood.Anchor.FLOOR)))
                : Optional.empty();
    }

    /** Returns the equal step of the wavelength, meters. */
    public Optional<Double> wavelengthStep() {
        return choices.find(WAVELENGTH_STEP);
    }

    boolean fixesBins() {
        return isThesis() || choices.has(WAVELENGTH_STEP);
    }

    public TableChoices withWavelengthStep(double meters) {
        return new TableChoices(choices.with(WAVELENGTH_STEP, meters));
    }
}
