package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.LevelledDirection;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.PeriodRemedy;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchSettings;

/** What another levelling would change of a scan's colours: the direction along which they are looked at, and whether it has a period. */
final class LevellingAdvice {
    private LevellingAdvice() {}

    /**
     * One line each; none of a surface that repeats without end.
     *
     * @param direction along which the surface is looked at
     */
    static List<String> of(Patch patch, PrincipalDirection direction) {
        List<String> lines = new ArrayList<>();
        if (patch.repetition() == Patch.Repetition.PERIODIC) {
            return lines;
        }
        LevelledDirection.of(patch.scan())
                .ifPresent(levelled -> lines.add(String.format(
                        Locale.ROOT,
                        "as the scan is, it is looked at along %s; with %s %s its direction of most colour is at %s: level it so unless the difference is the surface's own",
                        direction.describe(),
                        OptionOrigin.INSTANCE.name(PatchSettings.LEVEL),
                        levelled.levelling().label(),
                        levelled.direction().describe())));
        boolean assumed = patch.repetition() != Patch.Repetition.NONE;
        if (!new PeriodFinder(patch.scan(), assumed).all().found()) {
            PeriodRemedy.in(patch.scan())
                    .ifPresent(remedy -> lines.add(
                            "the scan shows no period as it is, but " + remedy.describe(patch, OptionOrigin.INSTANCE)));
        }
        return lines;
    }
}
