package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.reference.WindowLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * A coherence area without edges, and what is seen of many of them.
 *
 * @param window its Gaussian
 * @param origin the sample under the window's maximum
 * @param average which power
 */
public record GaussianArea(CoherenceWindow window, WindowOrigin origin, Average average) implements CoherenceArea {
    /** Sunlight's, on the patch's centre. */
    public static final GaussianArea STANDARD = new GaussianArea(
            CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH),
            WindowOrigin.CENTRE,
            Average.COHERENT);

    /** The thesis's: sunlight's, on the corner. */
    public static final GaussianArea THESIS =
            new GaussianArea(STANDARD.window(), WindowOrigin.CORNER, Average.COHERENT);

    /** The settings that it comes from, beside the preset. */
    public static final List<Setting<?>> SETTINGS = List.of(WINDOW_ORIGIN, COHERENCE_LENGTH, AVERAGE);

    /** As chosen. */
    public static GaussianArea of(Choices choices) {
        boolean thesis = Preset.isThesis(choices);
        return new GaussianArea(
                windowOf(choices),
                choices.get(WINDOW_ORIGIN, thesis ? WindowOrigin.CORNER : WindowOrigin.CENTRE),
                choices.get(AVERAGE));
    }

    /** The window of the coherence length that was chosen. */
    public static CoherenceWindow windowOf(Choices choices) {
        return CoherenceWindow.ofCoherenceLength(choices.get(COHERENCE_LENGTH));
    }

    @Override
    public ExactLight over(HeightMap map, CieTable cie) {
        return new WindowLight(new ReferenceEvaluator(map, window, origin), window, cie, average == Average.ENSEMBLE);
    }

    /** The same with another window. */
    public GaussianArea with(CoherenceWindow other) {
        return new GaussianArea(other, origin, average);
    }

    /** The same with another average. */
    public GaussianArea with(Average other) {
        return new GaussianArea(window, origin, other);
    }
}
