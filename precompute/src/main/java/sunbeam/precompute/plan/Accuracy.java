package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.OptionalDouble;
import sunbeam.precompute.setting.Choices;

/** What stands in for the choices of a plan that nobody makes. */
public sealed interface Accuracy {

    /**
     * They are made for a relative error of power and XYZ.
     *
     * @param relativeError {@link ErrorBudget#FINEST}..{@link ErrorBudget#COARSEST}
     */
    record ByTolerance(double relativeError) implements Accuracy {
        /** What holds where nothing is chosen. */
        public static final ByTolerance STANDARD = new ByTolerance(ErrorBudget.STANDARD);

        public ByTolerance {
            TOLERANCE.kind().check(relativeError);
        }

        @Override
        public OptionalDouble tolerance() {
            return OptionalDouble.of(relativeError);
        }
    }

    /** They are the thesis's (design, section 5), which promise nothing. */
    record ThesisPreset() implements Accuracy {
        @Override
        public OptionalDouble tolerance() {
            return OptionalDouble.empty();
        }
    }

    /** The relative error that is promised, if any. */
    OptionalDouble tolerance();

    /** Whether the thesis's choices stand in. */
    default boolean isThesis() {
        return this instanceof ThesisPreset;
    }

    /**
     * As chosen.
     *
     * @throws sunbeam.precompute.setting.SettingException for a tolerance beside the thesis's preset
     */
    static Accuracy of(Choices choices) {
        if (choices.get(PRESET, Preset.NONE) == Preset.NONE) {
            return new ByTolerance(choices.get(TOLERANCE));
        }
        if (choices.has(TOLERANCE)) {
            throw choices.complaint(
                    TOLERANCE,
                    "contradicts ",
                    PRESET,
                    " " + choices.written(PRESET) + ", whose choices keep no tolerance; leave one of them out");
        }
        return new ThesisPreset();
    }
}
