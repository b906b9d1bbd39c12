package sunbeam.app.commands.inspect;

import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/**
 * What a command that draws would do with a patch where nothing else is chosen.
 *
 * @param plan for the default tolerance and any pair of directions; empty where none can be made
 * @param refusal why there is none, and what such a command needs; empty where there is one
 */
record DrawingPlan(Optional<PlanReport> plan, String refusal) {
    /** @param choices of the method that draws, for this patch */
    static DrawingPlan of(Patch patch, Choices choices) {
        FullMethod standard = FullMethod.of(choices);
        try {
            return new DrawingPlan(Optional.of(plan(patch, standard)), "");
        } catch (SettingException tooMuch) {
            return new DrawingPlan(Optional.empty(), tooMuch.getMessage());
        }
    }

    /** In the words of the options of the commands that draw. */
    private static PlanReport plan(Patch patch, FullMethod method) {
        return Choices.at(OptionOrigin.INSTANCE)
                .located(() -> new PlanReport(method.tablePlan(Surface.withoutIdentity(patch), VisibleRange.all())));
    }

    /** One line: what is planned, or why nothing is. */
    String summary() {
        return plan.map(PlanReport::summary).orElse("none; a command that draws would refuse it: " + refusal);
    }
}
