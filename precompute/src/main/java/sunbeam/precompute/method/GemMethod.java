package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.SPACING;

import java.util.List;
import java.util.OptionalDouble;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.GaussianArea;

/**
 * A grating's spacing and nothing else of the surface (GPU Gems, chapter 8); for comparison only.
 *
 * @param spacing distance of the lines in metres; empty for the patch's width, where it is one period
 * @param window the Gaussian coherence window
 */
public record GemMethod(OptionalDouble spacing, CoherenceWindow window) implements Method {
    /** Its name and settings. */
    public static final MethodType TYPE = new MethodType(
            "gem",
            "a grating's spacing alone, for comparison only.",
            List.of(SPACING, COHERENCE_LENGTH),
            choices -> new GemMethod(
                    choices.find(SPACING).map(OptionalDouble::of).orElseGet(OptionalDouble::empty),
                    GaussianArea.windowOf(choices)));

    public GemMethod {
        spacing.ifPresent(SPACING.kind()::check);
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod exact(HeightMap map) {
        return new ReferenceMethod(GaussianArea.STANDARD.with(window));
    }
}
