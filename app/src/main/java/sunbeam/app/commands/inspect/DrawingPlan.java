package sunbeam.app.commands.inspect;

import java.util.Locale;
import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/**
 * What a command that draws would do with a patch where nothing else is chosen.
 *
 * @param plan for the default tolerance and any pair of directions; empty where none can be made
 * @param refusal why there is none, and what such a command needs; empty where there is one
 */
record DrawingPlan(Optional<PlanReport> plan, String refusal) {
    // Each half as wide and high as the one before.
    private static final int TRIALS = 4;

    /** @param choices of the method that draws, for this patch */
    static DrawingPlan of(Patch patch, Choices choices) {
        FullMethod standard = FullMethod.of(choices);
        try {
            return new DrawingPlan(Optional.of(plan(patch, standard)), "");
        } catch (SettingException tooMuch) {
            return new DrawingPlan(Optional.empty(), tooMuch.getMessage() + fittingPart(patch, standard));
        }
    }

    /** In the words of the options of the commands that draw. */
    private static PlanReport plan(Patch patch, FullMethod method) {
        return Choices.at(OptionOrigin.INSTANCE)
                .located(() -> new PlanReport(method.tablePlan(Surface.withoutIdentity(patch), VisibleRange.all())));
    }

    /** The largest part in the middle that can be drawn, of those with halved sides; planned, not guessed. */
    private static String fittingPart(Patch patch, FullMethod method) {
        HeightMap scan = patch.scan();
        for (int trial = 1, parts = 2; trial <= TRIALS; trial++, parts *= 2) {
            double share = 0.5 - 0.5 / parts;
            Crop crop = new Crop(
                    share * scan.width(),
                    (1 - share) * scan.width(),
                    share * scan.height(),
                    (1 - share) * scan.height());
            try {
                plan(new Patch(patch.name(), scan.part(crop), patch.source(), patch.warnings()), method);
                return String.format(
                        Locale.ROOT,
                        "; a part of 1/%d of its width and height can be drawn as it is (--crop %s:%s,%s:%s)",
                        parts,
                        edge(crop.left()),
                        edge(crop.right()),
                        edge(crop.bottom()),
                        edge(crop.top()));
            } catch (SettingException stillTooMuch) {
                // A smaller part may do.
            } catch (IllegalArgumentException noSamples) {
                return "";
            }
        }
        return "";
    }

    /** As an option's value has it, without a blank. */
    private static String edge(double metres) {
        return Lengths.rounded(metres, 3).replace(" ", "");
    }

    /** One line: what is planned, or why nothing is. */
    String summary() {
        return plan.map(PlanReport::summary).orElse("none; a command that draws would refuse it: " + refusal);
    }
}
