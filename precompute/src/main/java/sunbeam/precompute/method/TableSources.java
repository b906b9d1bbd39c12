package sunbeam.precompute.method;

import java.util.function.Function;
import java.util.function.LongConsumer;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/** Where what tables are made of comes from. */
public interface TableSources {

    /** The Fourier table of the surface that a plan needs. */
    FourierTable fourier(Plan plan);

    /**
     * Colors of the surface by another method's shader, to be closed by the caller.
     *
     * @param tables what that shader reads
     * @param places that will be asked for in all
     */
    ColorSource colors(ShaderTables tables, long places);

    /**
     * Colors that are evaluated without a shader, with their progress shown; to be closed by the caller.
     *
     * @param source of somebody who takes how many more places are done
     * @param places that will be asked for in all
     */
    ColorSource shown(Function<LongConsumer, ColorSource> source, long places);

    /** Whether earlier runs have made tiles of the surface, by any plan. */
    boolean hasTiles();

    /** Tiles of a table of all lights that earlier runs have made; to be closed by the caller. */
    CachedTiles cached(ColorTablePlan plan);

    /** Takes lines about what is done otherwise than planned. */
    ValidatedTable.Told told();
}
