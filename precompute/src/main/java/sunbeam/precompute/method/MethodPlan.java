package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.work.Progress;

/**
 * Plan of a method for a surface and the directions that can occur.
 *
 * @param explanation a line per choice, with its reason
 * @param spectrum plan of the sums that the shader takes, or from which its tables are baked; empty if there is none
 * @param colorTable levels whose tiles are baked on demand, so that {@link #tables} has no texels; empty for other methods
 * @param identity text that determines the tables, except for the use
 * @param maker makes the shader's tables for a supported use
 */
public record MethodPlan(
        String summary,
        Supplier<List<String>> explanation,
        Optional<SpectrumPlan> spectrum,
        Optional<ColorTablePlan> colorTable,
        MemoryNeed memory,
        Set<MethodUse> uses,
        Supplier<String> identity,
        BiFunction<MethodUse, TableSources, ShaderTables> maker) {
    public List<String> reasons() {
        return explanation.get();
    }

    /** Returns a line per reason that breaks the tolerance. */
    public List<Sentence> warnings() {
        return spectrum.map(SpectrumPlan::warnings).orElse(List.of());
    }

    /** Returns those warnings that no choice of settings avoids. */
    public List<Sentence> shortfalls() {
        return spectrum.map(SpectrumPlan::shortfalls).orElse(List.of());
    }

    /** Returns the plan of the sums that the shader takes at every wavelength; empty if it takes none. */
    public Optional<SpectrumPlan> fullSpectrumPlan() {
        // Tables of colors have no power at single wavelengths.
        return spectrum.filter(sums -> uses.contains(MethodUse.SPECTRAL));
    }

    public String key(MethodUse use) {
        return identity.get() + "|" + use;
    }

    /** Returns the shader's tables for a supported use; layers of large arrays are computed on demand. */
    public ShaderTables tables(MethodUse use, TableSources sources) {
        return maker.apply(use, sources);
    }

    /** Source of a surface's tables, which makes them or reads them from caches. */
    public interface TableSources {
        FourierTable fourier(SpectrumPlan plan);

        ShaderTables tables(MethodPlan plan);

        /** Opens a baker that runs the shader of these tables; the caller closes it. */
        ColorBaker baker(ShaderTables tables);

        /** Shows the progress of baking samples until the caller closes it. */
        Progress progress(long samples);

        boolean hasTiles();

        boolean hasTiles(ColorTablePlan plan);

        /** The caller closes it. */
        CachedTiles tiles(ColorTablePlan plan);

        ValidatedTable.Diagnostics diagnostics();
    }
}
