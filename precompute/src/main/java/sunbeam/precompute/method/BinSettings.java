package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.plan.Accuracy;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Neighbourhood.Anchor;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** What the methods have in common that sum over bins under a Gaussian window. */
final class BinSettings {
    private static final int THESIS_RADIUS = 1;

    /** In a manual's order. */
    static final List<Setting<?>> ALL = List.of(
            PRESET,
            TOLERANCE,
            EXPANSION,
            TERMS,
            RADIUS,
            ANCHOR,
            WAVELENGTH_STEP,
            WINDOW_ORIGIN,
            COHERENCE_LENGTH,
            AVERAGE);

    private BinSettings() {}

    /** The neighbourhood, where anything of it was chosen. An anchor by itself has the thesis's radius or none. */
    static Optional<Neighbourhood> neighbourhood(Choices choices) {
        boolean thesis = Accuracy.of(choices).isThesis();
        if (!choices.has(RADIUS) && !choices.has(ANCHOR)) {
            return Optional.empty();
        }
        if (!choices.has(RADIUS) && !thesis) {
            throw choices.complaint(
                    ANCHOR,
                    "is the middle of a neighbourhood of bins, but no radius is given; add for example ",
                    RADIUS,
                    " 3, or leave ",
                    ANCHOR,
                    " out");
        }
        return Optional.of(new Neighbourhood(
                choices.get(RADIUS, THESIS_RADIUS), choices.get(ANCHOR, thesis ? Anchor.FLOOR : Anchor.NEAREST)));
    }
}
