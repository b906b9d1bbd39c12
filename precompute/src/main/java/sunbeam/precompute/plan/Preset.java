package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.PRESET;

import sunbeam.precompute.setting.Choices;

/** Source of the defaults. */
public enum Preset {
    /** Planned for the tolerance. */
    NONE,
    /** The thesis's, which settings override one by one (docs/theory.md lists them). */
    THESIS;

    public static boolean isThesis(Choices choices) {
        return choices.get(PRESET, NONE) == THESIS;
    }
}
