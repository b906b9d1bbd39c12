package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.patch.HeightMap;

/** What breaks the tolerance that is promised: parts that a user fixed, or a tolerance at the edge of float32. */
final class PlanWarnings {
    private final Plan plan;
    private final HeightMap map;

    PlanWarnings(Plan plan, HeightMap map) {
        this.plan = plan;
        this.map = map;
    }

    /** One line each; none for what was planned for a tolerance well within float32, nor for the thesis's choices, which promise nothing. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        plan.accuracy().tolerance().ifPresent(tolerance -> {
            checkFloat32(tolerance, lines);
            checkTerms(tolerance, lines);
            lines.addAll(plan.sampling().warnings(plan, tolerance, map));
        });
        return lines;
    }

    private void checkFloat32(double tolerance, List<String> lines) {
        if (tolerance < Tolerances.FINEST_CERTAIN) {
            lines.add(format(
                    "float32 keeps the tolerance %s in the median, but leaves errors of up to %s at the 95th percentile of"
                            + " power, of which three times the tolerance is promised; 'reflectance --method reference'"
                            + " goes further",
                    shown(tolerance), shown(Tolerances.FLOAT32_PERCENTILE)));
        }
    }

    private void checkTerms(double tolerance, List<String> lines) {
        Expansion expansion = plan.expansion();
        double error = expansion instanceof LowRankExpansion lowRank
                ? lowRank.rootMeanSquareError()
                : expansion.errorBound(expansion.maximumPhase());
        if (error > tolerance) {
            lines.add(format(
                    "%d %s terms leave an error of %.1g, more than the tolerance %s; give more --terms, or leave it out",
                    expansion.terms(), expansion.kind().label(), error, tolerance));
        }
    }

    /** As people write it: 1e-5, not 1.0E-5. */
    private static String shown(double value) {
        return Double.toString(value).replaceFirst("\\.0(E|$)", "$1").replace('E', 'e');
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
