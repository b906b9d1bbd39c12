package sunbeam.precompute.method;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.GaussianPyramid;
import sunbeam.precompute.colortable.RadialBaker;
import sunbeam.precompute.colortable.SlopeBaker;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.method.MethodPlan.TableSources;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.spectrum.PowerSpectrum;

/** Bakers of a table of all directions: one power spectrum for all levels, or the shader of method full if coherent. Thread-safe. */
public final class LevelBakers {
    private final ColorTablePlan plan;
    private final TableSources sources;
    private final Lazy<PowerSpectrum> spectrum;
    private final Lazy<GaussianPyramid> pyramid;

    public LevelBakers(ColorTablePlan plan, TableSources sources) {
        this.plan = plan;
        this.sources = sources;
        this.spectrum = new Lazy<>(() -> {
            SpectrumPlan bins = plan.spectrum().orElseThrow();
            return PowerSpectrum.of(sources.fourier(bins), new ErrorBudget(plan.tolerance()).powerBasis());
        });
        this.pyramid = new Lazy<>(() -> new GaussianPyramid(spectrum.get(), plan.table()));
    }

    public ColorTable table() {
        return plan.table();
    }

    /** Opens the cache of tiles, to be closed by the caller. */
    public CachedTiles cached() {
        return sources.tiles(plan);
    }

    /** Computes the data that all bakers share. If tiles are cached, it is left to the first baker that is opened. */
    public void prepare() {
        if (plan.spectrum().isPresent() && !sources.hasTiles(plan)) {
            spectrum.get();
        }
    }

    public TableSources sources() {
        return sources;
    }

    /** Opens the baker of a level, to be closed by the caller. */
    public ColorBaker level(int level) {
        if (plan.spectrum().isEmpty()) {
            return sources.baker(sources.tables(plan.source(level)));
        }
        CieTable cie = plan.surface().cie();
        return table().slopeDeviation() > 0
                ? new SlopeBaker(spectrum.get(), cie, pyramid.get(), table(), level)
                : new RadialBaker(spectrum.get(), cie, table().levels().get(level));
    }

    /** Opens a baker of colors at points, not averaged over slopes as all levels are, to the table's tolerance. */
    public ColorBaker points() {
        if (table().slopeDeviation() == 0) {
            return level(0);
        }
        TableDesign design = TableDesign.within(
                plan.tolerance(),
                table().area(),
                TableDesign.depth(plan.surface().map()));
        return new RadialBaker(
                spectrum.get(), plan.surface().cie(), table().area(), design, TableSpace.AllLights.REACH, true);
    }

    /** Value computed once, without a lock, by the first thread that needs it. After a failure the next call tries again. */
    static final class Lazy<T> {
        private final Supplier<T> maker;
        private volatile FutureTask<T> task;

        Lazy(Supplier<T> maker) {
            this.maker = maker;
            task = new FutureTask<>(maker::get);
        }

        T get() {
            FutureTask<T> current = task;
            current.run(); // does nothing once another thread has begun
            try {
                return current.get();
            } catch (ExecutionException failure) {
                task = new FutureTask<>(maker::get);
                if (failure.getCause() instanceof Error error) {
                    throw error;
                }
                throw (RuntimeException) failure.getCause();
            } catch (InterruptedException interrupted) {
                throw new IllegalStateException("interrupted while another thread made the value", interrupted);
            }
        }
    }
}
