package sunbeam.precompute.method;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.LinearTrial;
import sunbeam.precompute.colortable.TileCells;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.rays.RaySpectrum;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.text.Text;

/**
 * {@link TableMethod} for all lights and views, in levels for pixels of any size: which tiles are looked into shows once pixels are known. Its
 * tables have the levels' settings; tiles are made by who draws. A coarse level is planned when it is asked for.
 */
public final class ColorTablePlan implements MethodPlan {
    private static final int CHANNELS = 4;

    private final Surface surface;
    private final ColorTable levels;
    private final double relief;
    private final double tolerance;
    private final Roughness roughness;
    private final MethodPlan finest;

    /**
     * Plans the finest level.
     *
     * @param relief of the surface, as the levels take it
     * @param tolerance of what is tabulated
     */
    ColorTablePlan(Surface surface, ColorTable levels, double relief, double tolerance) {
        this.surface = surface;
        this.levels = levels;
        this.relief = relief;
        this.tolerance = tolerance;
        this.roughness = surface.planner().roughness(TableChoices.within(tolerance), levels.area(), VisibleRange.all());
        this.finest = planned(0);
    }

    /** The same with other levels, whose finest has the same window. */
    private ColorTablePlan(ColorTablePlan other, ColorTable levels) {
        this.surface = other.surface;
        this.levels = levels;
        this.relief = other.relief;
        this.tolerance = other.tolerance;
        this.roughness = other.roughness;
        this.finest = other.finest;
    }

    private MethodPlan planned(int level) {
        TableChoices table = TableChoices.within(tolerance);
        Plan plan = surface.planner().plan(table, levels.levels().get(level).area(), VisibleRange.all(), roughness);
        return FullMethod.planned(surface, plan);
    }

    /** The table: its levels, their steps and windows. */
    public ColorTable table() {
        return levels;
    }

    /** The plan for a surface whose orders stand alone (see {@link LinearTrial}). */
    public ColorTablePlan ofLoneOrders() {
        return new ColorTablePlan(this, ColorTable.within(levels.tolerance(), levels.area(), relief, true));
    }

    /**
     * The plan for a surface with relief finer than a pixel; the same where footprints see that, and for a coherent average, whose mean
     * over slopes no table has.
     *
     * @param slopeDeviation standard deviation of its slopes along either axis; 0 for none
     */
    public ColorTablePlan onRelief(double slopeDeviation) {
        if (!ColorTable.isOfRelief(slopeDeviation) || levels.area().average() == Average.COHERENT) {
            return this;
        }
        return new ColorTablePlan(
                this, ColorTable.within(levels.tolerance(), levels.area(), relief, false, slopeDeviation));
    }

    /**
     * By what a level's colors are evaluated, for all (u, v, w).
     *
     * @param level its number in {@link #table()}
     */
    public MethodPlan source(int level) {
        return levels.levels().get(level).area().equals(levels.area()) ? finest : planned(level);
    }

    /** Relative error that evaluated colors may have. */
    public double tolerance() {
        return tolerance;
    }

    /** The plan of the bins by which all levels of an ensemble average are evaluated; empty for a coherent one. */
    public Optional<Plan> spectrum() {
        if (levels.area().average() == Average.COHERENT) {
            return Optional.empty();
        }
        return finest.sums()
                .map(plan -> RaySpectrum.widened(
                        plan,
                        surface.map().width(),
                        surface.map().height(),
                        levels.widest().window()));
    }

    @Override
    public Optional<ColorTablePlan> colorTable() {
        return Optional.of(this);
    }

    private int widths() {
        return levels.levels().size() - levels.ofPoints();
    }

    private String step(int level) {
        return Text.format("%.2g", levels.levels().get(level).design().step());
    }

    @Override
    public String summary() {
        return Text.format(
                "table: %d level%s from step %s in (u, v), %d slices in w; of %s",
                widths(), widths() == 1 ? "" : "s", step(levels.ofPoints()), levels.slices(), finest.summary());
    }

    @Override
    public List<String> reasons() {
        List<String> reasons = new ArrayList<>();
        reasons.add(Text.format(
                "step %s in (u, v): cubic B-splines through square roots of X, Y, Z err by the tolerance (docs/color-tables.md)",
                step(0)));
        if (levels.ofPoints() == 1) {
            reasons.add(Text.format(
                    "step %s where pixels see more than a point: the mean of lines between texels is as good as that of splines",
                    step(1)));
        }
        reasons.add(
                levels.area().average() == Average.COHERENT
                        ? "one level: a coherent average of wide surroundings is no narrower window's"
                        : Text.format(
                                "levels: %d, each 1.4 times as wide as the one before, for pixels that see so much",
                                widths()));
        reasons.add("evaluated by full for half of the tolerance:");
        reasons.addAll(finest.reasons());
        return reasons;
    }

    @Override
    public List<Sentence> warnings() {
        return finest.warnings();
    }

    @Override
    public List<Sentence> shortfalls() {
        return finest.shortfalls();
    }

    /** Tiles come on top, as they are looked at. */
    @Override
    public MemoryNeed memory() {
        return finest.memory();
    }

    @Override
    public boolean answers(MethodUse use) {
        return use == MethodUse.COLOR;
    }

    @Override
    public String key(MethodUse use) {
        return String.join("|", "levelled table", levels.toString(), finest.key(use));
    }

    /** One texel a level: u and v of its first coefficient, texels per unit, tiles across, scale of its power. */
    @Override
    public ShaderTables tables(MethodUse use, TableSources unused) {
        int count = levels.levels().size();
        float[] texels = new float[CHANNELS * count];
        IntStream.range(0, count).forEach(i -> {
            ColorTable.Level level = levels.levels().get(i);
            TileGrid grid = TileGrid.of(level);
            texels[CHANNELS * i] = (float) grid.firstX();
            texels[CHANNELS * i + 1] = (float) (1 / level.design().step());
            texels[CHANNELS * i + 2] = grid.columns();
            texels[CHANNELS * i + 3] =
                    (float) (level.scale() / Math.pow(levels.numbers().scale(), 2));
        });
        return TileCells.define(
                        new ShaderTables.Builder("table_levels"),
                        TileGrid.of(levels.levels().get(0)))
                .array(TableArray.of(ArrayLayout.flat("colorLevels", count, 1, CHANNELS), texels))
                .define(
                        "COLOR_FILTER",
                        levels.levels().get(count - 1).interpolation().shaderFunction())
                .define("COLOR_POINT_LEVELS", levels.ofPoints())
                .build(
                        levels.area().window().sigmaMetres(),
                        levels.area().window().specularReach(CieTable.MAXIMUM_WAVELENGTH));
    }
}
