package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.Locale;
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
        return MemoryNeed.of(plan, rows).excess(heapLimit).isEmpty()
                && plan.sampling().loopSteps(plan) <= MOST_LOOP_STEPS;
    }

    /** @throws SettingException where a plan takes more */
    void require(Plan plan) {
        MemoryNeed need = MemoryNeed.of(plan, rows);
        need.excess(heapLimit).ifPresent(excess -> refuseMemory(plan, need, excess));
        if (plan.sampling().loopSteps(plan) > MOST_LOOP_STEPS) {
            refuseLoops(plan);
        }
    }

    private static void refuseMemory(Plan plan, MemoryNeed need, String excess) {
        double coherenceLength = plan.window().coherenceLength();
        String problem = String.format(
                Locale.ROOT,
                "and %d x %d DFT bins in %d terms %s; crop the patch",
                plan.bandX().count(),
                plan.bandY().count(),
                plan.expansion().terms(),
                excess);
        throw need.isTooLong()
                ? SettingException.of(COHERENCE_LENGTH, coherenceLength, problem)
                : SettingException.of(
                        COHERENCE_LENGTH,
                        coherenceLength,
                        problem + ", or give a coarser ",
                        TOLERANCE,
                        ", fewer ",
                        TERMS,
                        " or another ",
                        COHERENCE_LENGTH);
    }

    private static void refuseLoops(Plan plan) {
        double coherenceLength = plan.window().coherenceLength();
        String problem = String.format(
                Locale.ROOT,
                "takes %,d steps a pixel with %s, and graphics drivers end loops after 65,535; ",
                plan.sampling().loopSteps(plan),
                plan.sampling().summary(plan.range()));
        throw plan.sampling() instanceof BinSampling
                ? SettingException.of(
                        COHERENCE_LENGTH,
                        coherenceLength,
                        problem + "give a smaller ",
                        RADIUS,
                        " or a larger ",
                        WAVELENGTH_STEP)
                : SettingException.of(
                        COHERENCE_LENGTH,
                        coherenceLength,
                        problem + "give another ",
                        COHERENCE_LENGTH,
                        ", a coarser ",
                        TOLERANCE,
                        ", or crop the patch");
    }
}
