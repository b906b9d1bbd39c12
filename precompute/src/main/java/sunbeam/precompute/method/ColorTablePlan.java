package sunbeam.precompute.method;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.AtlasPages;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.text.Text;

/**
 * Plan of {@link TableMethod} for all lights and views, of an effective relief in meters ({@link TableDesign#depth}). Its shader tables
 * hold no tiles, which are baked on demand; {@link #source} plans coarse levels when they are needed.
 */
public record ColorTablePlan(
        Surface surface, ColorTable table, double relief, double tolerance, Roughness roughness, MethodPlan finest) {
    private static final int CHANNELS = 4;

    static ColorTablePlan of(Surface surface, TableMethod method) {
        double relief = TableDesign.depth(surface.map());
        double tolerance = method.sourceTolerance();
        Roughness roughness =
                surface.planner().roughness(TableChoices.within(tolerance), method.area(), VisibleRange.all());
        ColorTable table =
                ColorTable.within(method.tolerance(), method.area(), relief, roughness.areOrdersIsolated(), 0);
        ColorTable.Level finest = table.levels().get(0);
        // The page table must fit; the scene checks the tiles of its pictures.
        ArrayLayout list = TileGrid.of(finest).tileList(table.levels().size());
        method.requireRoom(surface, finest.design(), new MemoryNeed(list.bytes(), List.of(list)));
        MethodPlan source = planned(surface, finest, tolerance, roughness);
        return new ColorTablePlan(surface, table, relief, tolerance, roughness, source);
    }

    private static MethodPlan planned(Surface surface, ColorTable.Level level, double tolerance, Roughness roughness) {
        TableChoices choices = TableChoices.within(tolerance);
        return FullMethod.planned(
                surface,
                surface.planner()
                        .ofTables(level.area().average())
                        .plan(choices, level.area(), VisibleRange.all(), roughness),
                FresnelFactor.ONCE);
    }

    /**
     * Returns the plan for slopes, finer than a pixel, of a standard deviation along either axis; this plan itself if they are too small,
     * or if the average is coherent, since no table has its mean over slopes.
     */
    public ColorTablePlan onRelief(double slopeDeviation) {
        if (!ColorTable.averages(slopeDeviation) || table.area().average() == Average.COHERENT) {
            return this;
        }
        ColorTable sloping = ColorTable.within(table.tolerance(), table.area(), relief, false, slopeDeviation);
        return new ColorTablePlan(surface, sloping, relief, tolerance, roughness, finest);
    }

    /** Returns the plan by which the colors of a level are evaluated. */
    public MethodPlan source(int level) {
        ColorTable.Level one = table.levels().get(level);
        return one.area().equals(table.area()) ? finest : planned(surface, one, tolerance, roughness);
    }

    /** Returns the plan of the power spectrum of an ensemble average; empty for a coherent average. */
    public Optional<SpectrumPlan> spectrum() {
        if (table.area().average() == Average.COHERENT) {
            return Optional.empty();
        }
        return finest.spectrum()
                .map(plan -> plan.widened(surface.map(), table.widest().window()));
    }

    private int footprintLevelCount() {
        return table.levels().size() - table.pointLevelCount();
    }

    private String step(int level) {
        return Text.format("%.2g", table.levels().get(level).design().step());
    }

    /** Returns this plan as a method's plan, whose memory does not include tiles. */
    public MethodPlan plan() {
        return new MethodPlan(
                summary(),
                this::reasons,
                finest.spectrum(),
                Optional.of(this),
                finest.memory(),
                EnumSet.of(MethodUse.COLOR),
                this::identity,
                (use, sources) -> tables());
    }

    private String summary() {
        return Text.format(
                "table: %d level%s from step %s in (u, v), %d slices in w; of %s",
                footprintLevelCount(),
                footprintLevelCount() == 1 ? "" : "s",
                step(table.pointLevelCount()),
                table.slices(),
                finest.summary());
    }

    private List<String> reasons() {
        List<String> reasons = new ArrayList<>();
        reasons.add(Text.format(
                "step %s in (u, v): cubic B-splines through square roots of X, Y, Z err by the tolerance (docs/color-tables.md)",
                step(0)));
        if (table.pointLevelCount() == 1) {
            reasons.add(Text.format(
                    "step %s for pixels larger than a point: linear interpolation suffices for means", step(1)));
        }
        reasons.add(
                table.area().average() == Average.COHERENT
                        ? "one level: a coherent average over a pixel is not that of a narrower window"
                        : Text.format(
                                "levels: %d, each 1.4 times as wide as the one before, for larger pixels",
                                footprintLevelCount()));
        reasons.add("evaluated by full for half of the tolerance:");
        reasons.addAll(finest.reasons());
        return reasons;
    }

    private String identity() {
        String filters = table.levels().stream()
                .map(level -> level.interpolation().key())
                .distinct()
                .collect(Collectors.joining(" "));
        return "levelled table|" + table + "|" + filters + "|"
                + finest.identity().get();
    }

    /** One texel per level: u of its first coefficient (v is equal), texels per unit of u, tiles across, scale of its power. */
    private ShaderTables tables() {
        int count = table.levels().size();
        float[] texels = new float[CHANNELS * count];
        IntStream.range(0, count).forEach(i -> {
            ColorTable.Level level = table.levels().get(i);
            TileGrid grid = TileGrid.of(level);
            texels[CHANNELS * i] = (float) grid.firstX();
            texels[CHANNELS * i + 1] = (float) (1 / level.design().step());
            texels[CHANNELS * i + 2] = grid.columns();
            texels[CHANNELS * i + 3] =
                    (float) (level.scale() / Math.pow(table.numbers().scale(), 2));
        });
        return AtlasPages.define(
                        new ShaderTables.Builder("table_levels"),
                        TileGrid.of(table.levels().get(0)))
                .array(TableArray.of(ArrayLayout.flat("colorLevels", count, 1, CHANNELS), texels))
                .define(
                        "COLOR_FILTER",
                        table.levels().get(count - 1).interpolation().shaderFunction())
                .define("COLOR_POINT_LEVELS", table.pointLevelCount())
                .build(table.area().window());
    }
}
