package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.TablePoints;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;

/** Colors of {@link FullMethod}, tabulated over (u, v, w) beforehand: a few look-ups per pixel (docs/color-tables.md). */
public record TableMethod(double tolerance, GaussianArea area) implements Method {
    // The rest of the tolerance is for interpolation.
    private static final double SOURCE_SHARE = 0.5;

    public static final MethodType TYPE = new MethodType(
            "table",
            "colors of full, tabulated in advance: fastest if many pixels share a table; full is faster for a small map or a short list.",
            List.of(TOLERANCE, WINDOW_ORIGIN, COHERENCE_LENGTH, AVERAGE),
            TableMethod::of);

    public TableMethod {
        TOLERANCE.kind().check(tolerance);
    }

    private static TableMethod of(Choices choices) {
        return new TableMethod(choices.get(TOLERANCE), GaussianArea.of(choices));
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        return range.hasPoints()
                ? PointTable.of(surface, this, new TablePoints(range)).plan()
                : ColorTablePlan.of(surface, this).plan();
    }

    double sourceTolerance() {
        return Math.max(ErrorBudget.FINEST, SOURCE_SHARE * tolerance);
    }

    void requireRoom(Surface surface, TableDesign design, MemoryNeed need) {
        surface.planner().excess(need).ifPresent(excess -> {
            throw SettingException.of(
                    TOLERANCE,
                    tolerance,
                    Text.format(
                            "and a table of colors in steps of %.2g in (u, v) %s; give a coarser ",
                            design.step(), excess),
                    TOLERANCE,
                    ", a shorter ",
                    COHERENCE_LENGTH,
                    ", or ",
                    Methods.METHOD,
                    " full");
        });
    }
}
