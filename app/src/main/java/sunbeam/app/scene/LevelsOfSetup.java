package sunbeam.app.scene;

import java.util.function.LongConsumer;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.colours.LevelSources;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.colourtable.KeptPages;
import sunbeam.precompute.colourtable.TableLevels;
import sunbeam.precompute.method.LevelledPlan;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.rays.RayColours;
import sunbeam.precompute.rays.RaySpectrum;
import sunbeam.precompute.shader.MethodUse;

/**
 * What levels of colours are made by: ensemble averages all by one spectrum, along rays; others by the shader of their
 * method. What that needs is made, or read from the cache, when the first level is asked for.
 */
final class LevelsOfSetup implements LevelSources {
    private final DiffractionSetup setup;
    private final LevelledPlan plan;
    private final CieTable cie;
    private RaySpectrum spectrum;
    // Keeps what the spectrum is made of for later runs.
    private Runnable unsaved = () -> {};

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
    public ColourSource open(int level, LongConsumer done) {
        if (plan.spectrum().isEmpty()) {
            return GpuColours.of(setup.tables(plan.source(level), MethodUse.COLOUR, GpuColours::of), done);
        }
        TableLevels.Level wanted = plan.levels().levels().get(level);
        RaySpectrum terms = spectrum(plan.spectrum().get());
        boolean fine = wanted.area().equals(plan.levels().area());
        return new RayColours(terms, wanted.area(), wanted.design().step(), fine, done);
    }

    @Override
    public void prepare() {
        if (plan.spectrum().isPresent() && !setup.hasPages(plan)) {
            spectrum(plan.spectrum().get());
        }
    }

    @Override
    public synchronized void settle() {
        unsaved.run();
        unsaved = () -> {};
    }

    private synchronized RaySpectrum spectrum(Plan widened) {
        if (spectrum == null) {
            spectrum =
                    new RaySpectrum(widened, setup.table(widened, saving -> unsaved = saving), plan.tolerance(), cie);
        }
        return spectrum;
    }
}
