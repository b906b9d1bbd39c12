package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.setting.SettingException;

/**
 * What a plan may take of memory and of loops' steps.
 *
 * @param rows of the patch
 * @param heapLimit the most that Java's heap may take, bytes
 */
record PlanLimits(int rows, long heapLimit) {
    // Mesa's software renderer ends all loops of a pixel after 65,535 steps, without a word (shaders/include/loops.glsl
    // finds out). On graphics cards a pixel that takes more would take milliseconds.
    private static final long MOST_LOOP_STEPS = 60_000;

    boolean hold(Plan plan) {
        return excess(plan).isEmpty();
    }

    /** @throws SettingException where a plan takes more */
    void require(Plan plan) {
        excess(plan).ifPresent(excess -> {
            throw SettingException.of(
                    COHERENCE_LENGTH,
                    plan.window().coherenceLength(),
                    excess + "; crop the patch, or give a coarser ",
                    TOLERANCE,
                    ", fewer ",
                    TERMS,
                    ", a smaller ",
                    RADIUS,
                    ", a larger ",
                    WAVELENGTH_STEP,
                    " or another ",
                    COHERENCE_LENGTH);
        });
    }

    /** What a plan takes too much of, continuing "coherence length 65 um ...". */
    private Optional<String> excess(Plan plan) {
        long steps = plan.sampling().loopSteps(plan);
        Optional<String> loops = Optional.of(String.format(
                        Locale.ROOT,
                        "takes %,d steps a pixel with %s, and graphics drivers end loops after 65,535",
                        steps,
                        plan.sampling().summary(plan.range())))
                .filter(words -> steps > MOST_LOOP_STEPS);
        return MemoryNeed.of(plan, rows)
                .excess(heapLimit)
                .map(excess -> String.format(
                        Locale.ROOT,
                        "and %d x %d DFT bins in %d terms %s",
                        plan.bandX().count(),
                        plan.bandY().count(),
                        plan.expansion().terms(),
                        excess))
                .or(() -> loops);
    }
}
