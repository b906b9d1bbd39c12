package sunbeam.app.scene;

import java.util.function.LongConsumer;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.gpu.colors.LevelSources;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.KeptPages;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.method.LevelledPlan;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.rays.RayColors;
import sunbeam.precompute.rays.RaySpectrum;
import sunbeam.precompute.shader.MethodUse;

/**
 * What levels of colors are made by: ensemble averages all by one spectrum, along rays; others by the shader of their
 * method. What that needs is made when the first level is asked for.
 */
final class LevelsOfSetup implements LevelSources {
    private final DiffractionSetup setup;
    private final LevelledPlan plan;
    private final CieTable cie;
    private RaySpectrum spectrum;

    /** @param cie the light that the plan is for */
    LevelsOfSetup(DiffractionSetup setup, LevelledPlan plan, CieTable cie) {
        this.setup = setup;
        this.plan = plan;
        this.cie = cie;
    }

    @Override
    public TableLevels levels() {
        return plan.levels();
    }

    @Override
    public KeptPages kept() {
        return setup.pages(plan);
    }

    @Override
    public ColorSource open(int level, LongConsumer done) {
        if (plan.spectrum().isEmpty()) {
            return GpuColors.of(setup.tables(plan.source(level), MethodUse.COLOR, GpuColors::of), done);
        }
        TableLevels.Level wanted = plan.levels().levels().get(level);
        RaySpectrum terms = spectrum(plan.spectrum().get());
        boolean fine = wanted.area().equals(plan.levels().area());
        return new RayColors(
                terms, wanted.area(), wanted.design().step(), wanted.design().sliceStep(), fine, done);
    }

    @Override
    public void prepare() {
        if (plan.spectrum().isPresent() && !setup.hasPages(plan)) {
            spectrum(plan.spectrum().get());
        }
    }

    private synchronized RaySpectrum spectrum(Plan widened) {
        if (spectrum == null) {
            spectrum = new RaySpectrum(widened, setup.fourierTable(widened), plan.tolerance(), cie);
        }
        return spectrum;
    }
}
