package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.Arrays;
import java.util.Optional;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.Expansion.HeightScale;
import sunbeam.precompute.spectrum.Expansion.TaylorExpansion;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Limits beyond which a plan is refused. */
final class PlanChecks {
    // Per pixel: Mesa's software renderer silently ends all loops after 65,535 (shaders/include/loops.glsl).
    static final long MOST_LOOP_STEPS = 60_000;

    // Per coherence length. A Gaussian of deviation s sampled at a pitch p has replicas of its spectrum at distance 1 /
    // p; the first adds exp(-2 pi^2 s^2 / p^2), 3e-9 at s = p, to a coherent power's normalization.
    private static final double FEWEST_SAMPLES = 4;
    // Meters: the first order of a period of two samples is then 3 degrees from the mirror direction at 550 nm.
    private static final double COARSEST_PITCH = 5e-6;
    // Radians; the time to find an expansion's basis, half a minute here, grows with the third power.
    private static final double LARGEST_PHASE = 800;

    private PlanChecks() {}

    static void requireExpandable(HeightScale scale, double maximumPhase) {
        if (maximumPhase > LARGEST_PHASE) {
            throw SettingException.of(
                    EXPANSION,
                    Expansion.Kind.LOWRANK,
                    Text.format(
                            "does not reach over a relief of %s, whose phases are up to %.0f rad, more than %.0f; method"
                                    + " reference, for lists, takes any relief; else crop the patch",
                            Lengths.format(2 * scale.halfRange()), maximumPhase, LARGEST_PHASE));
        }
    }

    static void requireSamples(CoherenceWindow window, HeightMap map) {
        double pitch = Math.max(map.columns() > 1 ? map.pitchX() : 0, map.rows() > 1 ? map.pitchY() : 0);
        double coherenceLength = window.coherenceLength();
        if (coherenceLength < FEWEST_SAMPLES * pitch) {
            throw SettingException.of(
                    COHERENCE_LENGTH,
                    coherenceLength,
                    Text.format(
                            "is less than %.0f samples of the patch, which are %s apart; %s",
                            FEWEST_SAMPLES,
                            Lengths.format(pitch),
                            pitch > COARSEST_PITCH
                                    ? "so far apart, samples show no structure that diffracts light: check the scan's"
                                            + " size and its unit"
                                    : "give " + Lengths.format(FEWEST_SAMPLES * pitch) + " or more"));
        }
    }

    /**
     * Refuses terms whose squares overflow float32; or, unless the user chose their number, which may be inaccurate, terms that exceed
     * float32's digits: they grow up to e^phase before they cancel.
     */
    static TaylorExpansion requireFloats(TaylorExpansion expansion, boolean chosen, double tolerance) {
        double largest = expansion.largestTerm(expansion.maximumPhase());
        double reachable = Math.ulp(1f) * largest;
        if (chosen ? Math.pow(largest, 2) > Float.MAX_VALUE : reachable > tolerance) {
            String problem = chosen
                    ? Text.format("with %d terms leaves the range of float32", expansion.terms())
                    : Text.format("reaches only %.1g in float32", reachable);
            String relief = Text.format(
                    " at this relief (%s, phases up to %.1f); use lowrank",
                    Lengths.format(2 * expansion.scale().halfRange()), expansion.maximumPhase());
            throw SettingException.of(EXPANSION, Expansion.Kind.TAYLOR, problem + relief);
        }
        return expansion;
    }

    /** Refuses plans beyond the limits of memory and of a shader's loop steps. */
    static Optional<SettingException> refusal(SpectrumPlan plan, int rows, long heapLimit, long mostSteps) {
        return excess(plan, rows, heapLimit, mostSteps)
                .map(excess -> SettingException.of(
                        COHERENCE_LENGTH,
                        plan.window().coherenceLength(),
                        excess
                                + "; method table, for the ensemble average, and method reference, for lists, take less; else crop the"
                                + " patch, or give a coarser ",
                        TOLERANCE,
                        ", fewer ",
                        TERMS,
                        ", a smaller ",
                        RADIUS,
                        ", a larger ",
                        WAVELENGTH_STEP,
                        " or another ",
                        COHERENCE_LENGTH));
    }

    /** Returns which limit is exceeded, as the end of a sentence that begins with "coherence length 65 um". */
    private static Optional<String> excess(SpectrumPlan plan, int rows, long heapLimit, long mostSteps) {
        Optional<String> memory = Arrays.stream(MethodUse.values())
                .flatMap(use -> MemoryNeed.of(plan, use, rows).excess(heapLimit).stream())
                .findFirst();
        long steps = plan.sampling().loopSteps(plan);
        if (memory.isEmpty() && steps > mostSteps) {
            return Optional.of(Text.format(
                    "takes %,d steps a pixel with %s, more than %,d, beyond which graphics drivers may end loops",
                    steps, plan.sampling().summary(plan.range()), mostSteps));
        }
        return memory.map(excess -> Text.format(
                "and %s in %d terms %s", plan.bins(), plan.expansion().terms(), excess));
    }
}
