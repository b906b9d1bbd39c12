package sunbeam.precompute.method;

import sunbeam.precompute.colortable.BakeToken;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/** What the tables of a surface are made of, and where they are cached. */
public interface TableSources {

    /** The Fourier table that a plan needs. */
    FourierTable fourier(Plan plan);

    /** What another method's shader reads, cached. */
    ShaderTables tables(MethodPlan plan);

    /** Opens a baker by another method's shader, to be closed by the caller. */
    ColorBaker baker(ShaderTables tables);

    /** Shows the progress of baking a number of samples, until the caller closes it. */
    BakeToken progress(long samples);

    /** Whether earlier runs have made tiles of the surface, by any plan. */
    boolean hasTiles();

    /** Whether earlier runs have made tiles of a table. */
    boolean hasTiles(ColorTablePlan plan);

    /** Tiles of a table, those of earlier runs and those to come; to be closed by the caller. */
    CachedTiles tiles(ColorTablePlan plan);

    /** Takes lines about what is done otherwise than planned. */
    ValidatedTable.Told told();
}
