package sunbeam.app.scene;

import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.colours.LevelSources;
import sunbeam.app.terminal.progress.Progress;
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
    public ColourSource open(int level, long places) {
        if (plan.spectrum().isEmpty()) {
            return GpuColours.of(setup.tables(plan.source(level), MethodUse.COLOUR, GpuColours::of), places);
        }
        TableLevels.Level wanted = plan.levels().levels().get(level);
        RaySpectrum terms = spectrum(plan.spectrum().get());
        return new ShownColours(terms, wanted, level == 0, Progress.start("Colours", places));
    }

    private synchronized RaySpectrum spectrum(Plan widened) {
        if (spectrum == null) {
            spectrum = new RaySpectrum(widened, setup.table(widened), plan.tolerance(), cie);
        }
        return spectrum;
    }

    /** Colours whose progress is shown. */
    private static final class ShownColours implements ColourSource {
        private final RayColours colours;
        private final Progress progress;

        ShownColours(RaySpectrum spectrum, TableLevels.Level level, boolean fine, Progress progress) {
            this.progress = progress;
            this.colours = new RayColours(spectrum, level.area(), level.design().step(), fine, count -> {
                synchronized (progress) {
                    progress.step(count);
                }
            });
        }

        @Override
        public float[] xyz(float[] places) {
            return colours.xyz(places);
        }

        @Override
        public void close() {
            progress.close();
        }
    }
}
