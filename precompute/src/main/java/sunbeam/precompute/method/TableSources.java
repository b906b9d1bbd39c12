package sunbeam.precompute.method;

import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.spectrum.FourierTable;

/** Source of a surface's tables, which makes them or reads them from caches. */
public interface TableSources {

    FourierTable fourier(SpectrumPlan plan);

    /** Returns the cached shader tables of the method that evaluates a color table's texels. */
    ShaderTables tables(MethodPlan plan);

    /** Opens a baker that runs the shader of these tables; the caller closes it. */
    ColorBaker baker(ShaderTables tables);

    /** Shows the progress of baking a number of samples, until the caller closes it. */
    ColorBaker.Token progress(long samples);

    /** True if tiles of any table of the surface are cached. */
    boolean hasTiles();

    boolean hasTiles(ColorTablePlan plan);

    /** The caller closes it. */
    CachedTiles tiles(ColorTablePlan plan);

    ValidatedTable.Diagnostics diagnostics();
}
