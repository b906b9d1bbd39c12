package sunbeam.precompute.method;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.radial.GaussianPyramid;
import sunbeam.precompute.radial.PowerSpectrum;
import sunbeam.precompute.radial.RadialBaker;
import sunbeam.precompute.radial.SlopeBaker;

/**
 * Bakers of the levels of a table of all directions: of an ensemble average all by one power spectrum, of a coherent one by the shader of method
 * full. What they share is made when the first is opened. Any thread may open one.
 */
public final class LevelBakers {
    private final ColorTablePlan plan;
    private final TableSources sources;
    private final CieTable cie;
    private final Lazy<PowerSpectrum> spectrum;
    private final Lazy<GaussianPyramid> pyramid;

    /** Takes a plan of the surface that the sources belong to. */
    public LevelBakers(ColorTablePlan plan, TableSources sources) {
        this.plan = plan;
        this.sources = sources;
        this.cie = plan.surface().cie();
        this.spectrum = new Lazy<>(() -> {
            Plan bins = plan.spectrum().orElseThrow();
            return new PowerSpectrum(bins, sources.fourier(bins), plan.tolerance());
        });
        this.pyramid = new Lazy<>(() -> SlopeBaker.pyramid(spectrum.get(), plan.table()));
    }

    public ColorTable table() {
        return plan.table();
    }

    /** Tiles that are cached for later runs, to be closed by the caller; may be none. */
    public CachedTiles cached() {
        return sources.tiles(plan);
    }

    /** Makes what the bakers share, unless earlier runs have made tiles: without effect on the colors. */
    public void prepare() {
        if (plan.spectrum().isPresent() && !sources.hasTiles(plan)) {
            spectrum.get();
        }
    }

    /** Reports colors that miss their tolerance. */
    public void warn(String line) {
        sources.told().shortfall().accept(line);
    }

    /** Opens the baker of a level, to be closed by the caller. */
    public ColorBaker level(int level) {
        if (plan.spectrum().isEmpty()) {
            return sources.baker(sources.tables(plan.source(level)));
        }
        return table().slopeDeviation() > 0
                ? new SlopeBaker(spectrum.get(), cie, pyramid.get(), table(), level)
                : new RadialBaker(spectrum.get(), cie, table().levels().get(level));
    }

    /** Opens a baker of points of the patch, without the slopes that all levels are averages over; to be closed by the caller. */
    public ColorBaker points() {
        if (table().slopeDeviation() == 0) {
            return level(0);
        }
        ColorTable.Level finest = table().levels().get(0);
        return new RadialBaker(
                spectrum.get(),
                cie,
                table().area(),
                finest.design().step(),
                finest.design().sliceStep(),
                TableSpace.AllLights.REACH,
                true);
    }
}
