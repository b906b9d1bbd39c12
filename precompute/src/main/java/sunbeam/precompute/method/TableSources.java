package sunbeam.precompute.method;

import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.LevelBaking.CachedTiles;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.spectrum.FourierTable;

/** Source of a surface's tables, which makes them or reads them from caches. */
public interface TableSources {
    FourierTable fourier(SpectrumPlan plan);

    ShaderTables tables(MethodPlan plan);

    /** Opens a baker that runs the shader of these tables; the caller closes it. */
    ColorBaker baker(ShaderTables tables);

    /** Shows the progress of baking samples until the caller closes it. */
    ColorBaker.Token progress(long samples);

    boolean hasTiles();

    boolean hasTiles(ColorTablePlan plan);

    /** The caller closes it. */
    CachedTiles tiles(ColorTablePlan plan);

    ValidatedTable.Diagnostics diagnostics();
}
