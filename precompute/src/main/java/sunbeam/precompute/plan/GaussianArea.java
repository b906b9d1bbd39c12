package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Coherence area with a Gaussian window, and the average over positions of the window. */
public record GaussianArea(CoherenceWindow window, WindowOrigin origin, Average average) {
    public static final GaussianArea STANDARD = of(Choices.none());

    public static final List<Setting<?>> SETTINGS =
            List.of(MethodSettings.WINDOW_ORIGIN, MethodSettings.COHERENCE_LENGTH, MethodSettings.AVERAGE);

    public static GaussianArea of(Choices choices) {
        boolean thesis = Preset.isThesis(choices);
        return new GaussianArea(
                windowOf(choices),
                choices.get(MethodSettings.WINDOW_ORIGIN, thesis ? WindowOrigin.CORNER : WindowOrigin.CENTRE),
                choices.get(MethodSettings.AVERAGE));
    }

    public static CoherenceWindow windowOf(Choices choices) {
        return CoherenceWindow.ofCoherenceLength(choices.get(MethodSettings.COHERENCE_LENGTH));
    }

    public ExactLight over(HeightMap map, CieTable cie) {
        return new ExactLight.WindowLight(
                new ReferenceEvaluator(map, window, origin), cie, average == Average.ENSEMBLE);
    }

    public GaussianArea with(CoherenceWindow other) {
        return new GaussianArea(other, origin, average);
    }
}
