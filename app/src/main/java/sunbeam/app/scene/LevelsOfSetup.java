package sunbeam.app.scene;

import java.util.function.Consumer;
import java.util.function.LongConsumer;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.gpu.colors.LevelSources;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.LinearTrial;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.rays.PowerLadder;
import sunbeam.precompute.rays.RayColors;
import sunbeam.precompute.rays.RaySpectrum;
import sunbeam.precompute.rays.ReliefColors;
import sunbeam.precompute.shader.MethodUse;

/**
 * What levels of colors are made by: ensemble averages all by one spectrum, along rays; others by the shader of their
 * method. What that needs is made when the first level is asked for.
 */
final class LevelsOfSetup implements LevelSources {
    private final DiffractionSetup setup;
    private final ColorTablePlan plan;
    private final CieTable cie;
    private final Consumer<String> warning;
    private RaySpectrum spectrum;
    private PowerLadder ladder;

    private LevelsOfSetup(DiffractionSetup setup, ColorTablePlan plan, CieTable cie, Consumer<String> warning) {
        this.setup = setup;
        this.plan = plan;
        this.cie = cie;
        this.warning = warning;
    }

    /** Finds out whether lines between texels are good enough for a surface, by a trial or by which tiles are kept. */
    static LevelsOfSetup of(DiffractionSetup setup, ColorTablePlan plan, CieTable cie, Consumer<String> warning) {
        LevelsOfSetup levels = new LevelsOfSetup(setup, plan, cie, warning);
        if (plan.table().ofPoints() == 0) {
            return levels;
        }
        LevelsOfSetup lone = new LevelsOfSetup(setup, plan.ofLoneOrders(), cie, warning);
        if (setup.hasTiles(lone.plan)) {
            return lone;
        }
        if (setup.hasTiles(plan) || levels.linesPass()) {
            return levels;
        }
        lone.spectrum = levels.spectrum;
        return lone;
    }

    /** In the middle of the levels: in finer ones orders stand as much alone, and single colors take longer. */
    private boolean linesPass() {
        int middle = plan.table().levels().size() / 2;
        try (ColorSource source = open(middle, done -> {})) {
            return LinearTrial.passes(plan.table(), middle, source);
        }
    }

    /** The plan that suits the surface. */
    ColorTablePlan plan() {
        return plan;
    }

    @Override
    public ColorTable table() {
        return plan.table();
    }

    @Override
    public CachedTiles cached() {
        return setup.tiles(plan);
    }

    @Override
    public ColorSource open(int level, LongConsumer done) {
        if (plan.spectrum().isEmpty()) {
            return GpuColors.of(setup.tables(plan.source(level), MethodUse.COLOR, GpuColors::of), done);
        }
        ColorTable.Level wanted = plan.table().levels().get(level);
        RaySpectrum terms = spectrum(plan.spectrum().get());
        if (plan.table().slopeDeviation() > 0) {
            return new ReliefColors(terms, ladder(terms), plan.table(), level, done);
        }
        return new RayColors(
                terms, wanted.area(), wanted.design().step(), wanted.design().sliceStep(), wanted.wings(), done);
    }

    @Override
    public ColorSource openPoints(LongConsumer done) {
        if (plan.table().slopeDeviation() == 0) {
            return open(0, done);
        }
        TableDesign design = plan.table().levels().get(0).design();
        RaySpectrum terms = spectrum(plan.spectrum().get());
        return new RayColors(terms, plan.table().area(), design.step(), design.sliceStep(), true, done);
    }

    @Override
    public void warn(String line) {
        warning.accept(line);
    }

    @Override
    public void prepare() {
        if (plan.spectrum().isPresent() && !setup.hasTiles(plan)) {
            spectrum(plan.spectrum().get());
        }
    }

    private synchronized PowerLadder ladder(RaySpectrum terms) {
        if (ladder == null) {
            ladder = ReliefColors.ladder(terms, plan.table());
        }
        return ladder;
    }

    private synchronized RaySpectrum spectrum(Plan widened) {
        if (spectrum == null) {
            spectrum = new RaySpectrum(widened, setup.fourierTable(widened), plan.tolerance(), cie);
        }
        return spectrum;
    }
}
