package sunbeam.app.scene;

import java.util.Optional;
import sunbeam.precompute.analysis.EnergyBalance;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Treatment of light that scalar theory sends out beyond what arrives (docs/theory.md). */
public enum Energy {
    /** Scalar theory as it is. */
    SCALAR,
    /** Radiance is divided by this excess ({@link EnergyDivisor}). */
    CONSERVE;

    /** Meters; at shorter coherence lengths orders are so wide that the divisor errs by more than 2 %. */
    public static final double SHORTEST_WINDOW = 5e-6;
    // Meters; a deeper relief takes minutes.
    private static final double DEEPEST = 20e-6;

    /**
     * Returns the divisor; empty for SCALAR.
     *
     * @throws SettingException for a method, window or relief without a right divisor
     */
    public Optional<EnergyDivisor> divisor(HeightMap map, RefractiveIndex index, Choices choices) {
        if (this == SCALAR) {
            return Optional.empty();
        }
        CoherenceWindow window = GaussianArea.windowOf(choices);
        require(!Preset.isThesis(choices), "is not for the thesis's preset");
        require(
                !choices.get(Methods.METHOD).equals(ReferenceMethod.TYPE)
                        && Methods.of(choices).isNormalizedToMirror(),
                "is not for method " + choices.get(Methods.METHOD).label());
        require(window.coherenceLength() >= SHORTEST_WINDOW, "needs a coherence length of 5um at least");
        require(map.relief() <= DEEPEST, "is for a relief of at most 20 um");
        require(!EnergyBalance.hasTooManyOrders(map), "is for samples at most some micrometers apart");
        return Optional.of(new EnergyDivisor(map, index, window));
    }

    private static void require(boolean condition, String problem) {
        if (!condition) {
            throw SettingException.of(SceneSettings.ENERGY, CONSERVE, problem + "; leave it out");
        }
    }
}
