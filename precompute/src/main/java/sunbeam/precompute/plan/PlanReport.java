package sunbeam.precompute.plan;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.units.Lengths;

/** A plan in words. */
public final class PlanReport {
    private final Plan plan;

    public PlanReport(Plan plan) {
        this.plan = plan;
    }

    /** One line: what is computed, in words that need no knowledge of how. */
    public String summary() {
        return String.format(
                Locale.ROOT,
                "%s, coherence length %s, %s average, %s",
                accuracy(),
                Lengths.format(plan.window().coherenceLength()),
                plan.average().name().toLowerCase(Locale.ROOT),
                plan.sampling().summary(plan.range()));
    }

    private String accuracy() {
        OptionalDouble tolerance = plan.accuracy().tolerance();
        return tolerance.isPresent()
                ? String.format(
                        Locale.ROOT,
                        "colors planned to %s %% (95 %% of directions to %s %%)",
                        percent(tolerance.getAsDouble()),
                        percent(3 * tolerance.getAsDouble()))
                : "as in the thesis";
    }

    /** A share in words, without its sign. */
    public static String percent(double share) {
        return new BigDecimal(100 * share)
                .round(new MathContext(3))
                .stripTrailingZeros()
                .toPlainString();
    }

    private String terms() {
        Expansion expansion = plan.expansion();
        return expansion.terms() + " " + expansion.kind().label() + " terms";
    }

    private String bins() {
        return plan.bandX().count() + " x " + plan.bandY().count() + " DFT bins";
    }

    /**
     * One line: memory on the graphics card.
     *
     * @param patchRows of the height map
     */
    public String cost(int patchRows) {
        return "textures of at most "
                + MemoryNeed.inWords(MemoryNeed.of(plan, patchRows).textureBytes());
    }

    /** Several lines: each choice and its reason. */
    public List<String> reasons() {
        List<String> lines = new ArrayList<>();
        VisibleRange range = plan.range();
        lines.add("sizes: " + terms() + ", " + plan.sampling().summary(range) + ", " + bins());
        lines.add(format(
                "directions: u %.3f..%.3f, v %.3f..%.3f, |w| %.3f..%.3f can occur; nothing else is computed",
                range.minimumU(),
                range.maximumU(),
                range.minimumV(),
                range.maximumV(),
                range.minimumW(),
                range.maximumW()));
        Expansion expansion = plan.expansion();
        lines.add(format(
                "expansion: phases k |w| h of %.2f to %.2f rad take %s; error %.1e",
                expansion.minimumPhase(), expansion.maximumPhase(), terms(), expansion.error()));
        lines.add(format(
                "window: coherence length %s, its spectrum has a deviation of %.4g cycles per metre, centered on the %s",
                Lengths.format(plan.window().coherenceLength()),
                plan.window().sigmaFrequency(),
                plan.origin() == WindowOrigin.CORNER ? "corner" : "patch's center"));
        lines.add("bins: " + bins() + " reach every visible frequency at 380 nm and the window's width beyond");
        return lines;
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
