package sunbeam.precompute.plan;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** User's choices for Fourier tables, summed bins and wavelengths; the planner makes the others. */
public record TableChoices(Choices choices) {
    /** Settings of these choices, except the neighborhood's, which not all methods have. */
    public static final List<Setting<?>> SETTINGS = List.of(
            MethodSettings.PRESET,
            MethodSettings.TOLERANCE,
            MethodSettings.EXPANSION,
            MethodSettings.TERMS,
            MethodSettings.WAVELENGTH_STEP);

    private static final List<Setting<?>> BINS = List.of(MethodSettings.RADIUS, MethodSettings.ANCHOR);

    /** Ignores settings of others; throws SettingException if the choices contradict each other. */
    public TableChoices {
        choices = choices.only(Setting.union(SETTINGS, BINS));
        boolean thesis = Preset.isThesis(choices);
        if (thesis && choices.has(MethodSettings.TOLERANCE)) {
            throw choices.complaint(
                    MethodSettings.TOLERANCE,
                    "contradicts ",
                    MethodSettings.PRESET,
                    " " + choices.written(MethodSettings.PRESET)
                            + ", whose choices keep no tolerance; leave one of them out");
        }
        for (Setting<?> setting : BINS) {
            if (!thesis && choices.has(setting)) {
                throw choices.complaint(
                        setting,
                        "is of the thesis's bins, which a plan for a tolerance does not sum; leave it out, or give ",
                        MethodSettings.PRESET,
                        " thesis");
            }
        }
        choices = thesis ? choices : choices.without(MethodSettings.PRESET).orStandard(MethodSettings.TOLERANCE);
    }

    public static TableChoices within(double tolerance) {
        return new TableChoices(Choices.none().with(MethodSettings.TOLERANCE, tolerance));
    }

    public boolean isThesis() {
        return Preset.isThesis(choices);
    }

    double tolerance() {
        return choices.get(MethodSettings.TOLERANCE);
    }

    /** Returns the bins summed around each frequency; empty except for the thesis's choices. */
    public Optional<Neighborhood> neighborhood() {
        return isThesis()
                ? Optional.of(new Neighborhood(
                        choices.get(MethodSettings.RADIUS, 1),
                        choices.get(MethodSettings.ANCHOR, Neighborhood.Anchor.FLOOR)))
                : Optional.empty();
    }

    /** Returns the equal step of the wavelength, meters. */
    public Optional<Double> wavelengthStep() {
        return choices.find(MethodSettings.WAVELENGTH_STEP);
    }

    boolean fixesBins() {
        return isThesis() || choices.has(MethodSettings.WAVELENGTH_STEP);
    }

    public TableChoices withWavelengthStep(double meters) {
        return new TableChoices(choices.with(MethodSettings.WAVELENGTH_STEP, meters));
    }
}
