package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.PRESET;

import sunbeam.precompute.setting.Choices;

/** Where choices come from that the user does not make. */
public enum Preset {
    /** Planned for the tolerance. */
    NONE,
    /** The thesis's, each of which a setting of its own overrides (docs/theory.md lists them). */
    THESIS;

    /** Whether the thesis's choices stand in for those that are not made. */
    public static boolean isThesis(Choices choices) {
        return choices.get(PRESET, NONE) == THESIS;
    }
}
