package sunbeam.precompute.method;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.Interpolation;
import sunbeam.precompute.colortable.RadialBaker;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.colortable.ValidatedTable.TablePoints;
import sunbeam.precompute.method.MethodPlan.TableSources;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.text.Text;

/** Colors of {@link FullMethod}, tabulated over (u, v, w) beforehand: a few look-ups per pixel (docs/color-tables.md). */
public record TableMethod(double tolerance, GaussianArea area) implements Method {
    // The rest of the tolerance is for interpolation.
    private static final double SOURCE_SHARE = 0.5;

    public static final MethodType TYPE = new MethodType(
            "table",
            "colors of full, tabulated in advance: fastest if many pixels share a table; full is faster for a small map or a short list.",
            List.of(
                    MethodSettings.TOLERANCE,
                    MethodSettings.WINDOW_ORIGIN,
                    MethodSettings.COHERENCE_LENGTH,
                    MethodSettings.AVERAGE),
            choices -> new TableMethod(choices.get(MethodSettings.TOLERANCE), GaussianArea.of(choices)));

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        // In maps and lists, single points occur alone: a table may hold only those.
        return range.light().isPresent() || !range.pairs().isEmpty()
                ? PointTable.of(surface, this, new TablePoints(range)).plan()
                : ColorTablePlan.of(surface, this).plan();
    }

    double sourceTolerance() {
        return Math.max(ErrorBudget.FINEST, SOURCE_SHARE * tolerance);
    }

    void requireRoom(Surface surface, TableDesign design, MemoryNeed need) {
        surface.planner().excess(need).ifPresent(excess -> {
            throw SettingException.of(
                            MethodSettings.TOLERANCE,
                            tolerance,
                            Text.format(
                                    "and a table of colors in steps of %.2g in (u, v) %s; give a coarser ",
                                    design.step(), excess.words()),
                            MethodSettings.TOLERANCE,
                            ", a shorter ",
                            MethodSettings.COHERENCE_LENGTH,
                            ", or ",
                            Methods.METHOD,
                            " full")
                    .because(excess);
        });
    }

    /**
     * {@link TableMethod} for a map or a list of directions: uses cached tiles of the table of all lights if these suffice; otherwise bakes a
     * table for its own points, with steps refined until colors keep the tolerance.
     */
    private record PointTable(
            Surface surface, TableMethod method, TablePoints points, TableDesign coarsest, MethodPlan source) {
        // Factor of the first table's steps, at which an ensemble average errs by a fifth of the tolerance's share.
        private static final double COARSE = 1.3;

        static PointTable of(Surface surface, TableMethod method, TablePoints points) {
            // A coherent average, with zeros between its speckles, begins with finer steps.
            double coarse = method.area().average() == Average.COHERENT ? 1 : COARSE;
            TableDesign coarsest = TableDesign.within(
                            method.tolerance(), method.area(), TableDesign.depth(surface.map()))
                    .scaled(coarse);
            method.requireRoom(surface, coarsest, points.memory(coarsest));
            TableChoices choices = TableChoices.within(method.sourceTolerance());
            Planner planner = surface.planner().ofTables(method.area().average());
            SpectrumPlan source = planner.plan(choices, method.area(), points.range(coarsest));
            return new PointTable(
                    surface, method, points, coarsest, FullMethod.planned(surface, source, FresnelFactor.ONCE));
        }

        MethodPlan plan() {
            MemoryNeed memory = points.memory(coarsest);
            return new MethodPlan(
                    Text.format(
                            "table to %s %%: %s, step at most %.2g in (u, v), %.0f MB or more; made of %s",
                            SpectrumPlan.percent(method.tolerance()),
                            points.light().isPresent() ? "one light" : coarsest.slices() + " slices in w",
                            coarsest.step(),
                            memory.textureBytes() * 1e-6,
                            source.summary()),
                    this::reasons,
                    source.spectrum(),
                    Optional.empty(),
                    memory,
                    EnumSet.of(MethodUse.COLOR),
                    () -> "validated table 6|" + method.tolerance() + "|" + coarsest + "|" + points.key() + "|"
                            + Interpolation.CUBIC.key() + "|"
                            + source.identity().get(),
                    this::tables);
        }

        private List<String> reasons() {
            List<String> reasons = new ArrayList<>();
            reasons.add(Text.format(
                    "step %.2g in (u, v), or smaller if the validation requires it: cubic B-splines through square roots of X, Y, Z err by"
                            + " the tolerance (docs/color-tables.md)",
                    coarsest.step()));
            reasons.add(
                    points.light().isPresent()
                            ? "one slice: w follows from u and v under one light"
                            : Text.format("%d slices in w, interpolated by cubic polynomials", coarsest.slices()));
            reasons.add("evaluated by full for half of the tolerance:");
            reasons.addAll(source.reasons());
            return reasons;
        }

        private ShaderTables tables(MethodUse use, TableSources sources) {
            Function<TableDesign, ColorBaker> bakers = bakers(use, sources);
            ValidatedTable table = cached(sources, bakers)
                    .orElseGet(() -> ValidatedTable.make(
                            method.tolerance(),
                            points,
                            coarsest,
                            bakers,
                            sources::progress,
                            need -> surface.planner().excess(need).isEmpty(),
                            design -> method.requireRoom(surface, design, points.memory(design)),
                            sources.diagnostics()));
            ShaderTables.Builder tables = new ShaderTables.Builder("table").trial(table.words(method.tolerance()));
            table.putInto(tables);
            return tables.build(method.area().window());
        }

        private Optional<ValidatedTable> cached(TableSources sources, Function<TableDesign, ColorBaker> bakers) {
            if (!sources.hasTiles()) {
                return Optional.empty();
            }
            ColorTablePlan all = ColorTablePlan.of(surface, method);
            if (!sources.hasTiles(all)) {
                return Optional.empty();
            }
            try (CachedTiles tiles = sources.tiles(all)) {
                return ValidatedTable.cached(all.table(), points, tiles, bakers, sources::progress);
            }
        }

        private Function<TableDesign, ColorBaker> bakers(MethodUse use, TableSources sources) {
            if (method.area().average() == Average.COHERENT) {
                ShaderTables evaluated = source.tables(use, sources);
                return design -> sources.baker(evaluated);
            }
            SpectrumPlan widened = source.spectrum()
                    .orElseThrow()
                    .widened(surface.map(), method.area().window());
            PowerSpectrum spectrum =
                    PowerSpectrum.of(sources.fourier(widened), new ErrorBudget(method.sourceTolerance()).powerBasis());
            return design -> new RadialBaker(spectrum, surface.cie(), method.area(), design, points.farthest(), true);
        }
    }
}
