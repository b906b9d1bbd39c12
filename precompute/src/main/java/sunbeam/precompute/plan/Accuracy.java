package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Optional;
import sunbeam.precompute.setting.Choices;

/**
 * What stands in for the choices of a plan that nobody makes.
 *
 * @param tolerance relative error of power and XYZ that they are made for; empty for the thesis's choices (design, section
 *     5), which promise nothing
 */
public record Accuracy(Optional<Double> tolerance) {
    /** What holds where nothing is chosen. */
    public static final Accuracy STANDARD = within(ErrorBudget.STANDARD);

    public static final Accuracy THESIS = new Accuracy(Optional.empty());

    public Accuracy {
        tolerance.ifPresent(TOLERANCE.kind()::check);
    }

    /** {@link ErrorBudget#FINEST}..{@link ErrorBudget#COARSEST}. */
    public static Accuracy within(double tolerance) {
        return new Accuracy(Optional.of(tolerance));
    }

    /** Whether the thesis's choices stand in. */
    public boolean isThesis() {
        return tolerance.isEmpty();
    }

    /**
     * As chosen.
     *
     * @throws sunbeam.precompute.setting.SettingException for a tolerance beside the thesis's preset
     */
    static Accuracy of(Choices choices) {
        if (!Preset.isThesis(choices)) {
            return within(choices.get(TOLERANCE));
        }
        if (choices.has(TOLERANCE)) {
            throw choices.complaint(
                    TOLERANCE,
                    "contradicts ",
                    PRESET,
                    " " + choices.written(PRESET) + ", whose choices keep no tolerance; leave one of them out");
        }
        return THESIS;
    }
}
