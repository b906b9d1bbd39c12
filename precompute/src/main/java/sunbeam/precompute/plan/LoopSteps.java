package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.Locale;
import sunbeam.precompute.setting.SettingException;

/**
 * Mesa's software renderer ends all loops of a pixel after so many steps, without a word (shaders/include/loops.glsl finds
 * out). On graphics cards a pixel that takes more would take milliseconds.
 */
final class LoopSteps {
    /** The most that a plan may take; Mesa's limit is 65,535. */
    static final long MOST = 60_000;

    private LoopSteps() {}

    static boolean fit(Plan plan) {
        return plan.sampling().loopSteps(plan) <= MOST;
    }

    /** @throws SettingException where a plan takes more */
    static void require(Plan plan) {
        if (fit(plan)) {
            return;
        }
        String problem = String.format(
                Locale.ROOT,
                "takes %,d steps a pixel with %s, and graphics drivers end loops after 65,535; ",
                plan.sampling().loopSteps(plan),
                plan.sampling().summary(plan.range()));
        if (plan.sampling() instanceof BinSampling) {
            throw SettingException.of(
                    COHERENCE_LENGTH,
                    plan.window().coherenceLength(),
                    problem + "give a smaller ",
                    RADIUS,
                    " or a larger ",
                    WAVELENGTH_STEP);
        }
        throw SettingException.of(
                COHERENCE_LENGTH,
                plan.window().coherenceLength(),
                problem + "give another ",
                COHERENCE_LENGTH,
                ", a coarser ",
                TOLERANCE,
                ", or crop the patch");
    }
}
