package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.PRESET;

import sunbeam.precompute.setting.Choices;

/** Source of the default settings. */
public enum Preset {
    /** Defaults are planned for the tolerance. */
    NONE,
    /** Defaults are the thesis's values (docs/theory.md), which settings override one by one. */
    THESIS;

    public static boolean isThesis(Choices choices) {
        return choices.get(PRESET, NONE) == THESIS;
    }
}
