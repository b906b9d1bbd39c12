package sunbeam.precompute.plan;

import sunbeam.precompute.setting.Choices;

/** Source of the default settings. */
public enum Preset {
    NONE,
    /** The values are in docs/theory.md. */
    THESIS;

    public static boolean isThesis(Choices choices) {
        return choices.get(MethodSettings.PRESET, NONE) == THESIS;
    }
}
