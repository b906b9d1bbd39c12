package sunbeam.app.gpu.colors;

import java.util.BitSet;
import java.util.List;

/** Bakes tiles of a color table. Not thread-safe. */
interface TileBaker extends AutoCloseable {
    /**
     * Tiles of one level that are baked together.
     *
     * @param tiles numbers of the tiles, at least one
     */
    record Job(int level, BitSet tiles) {}

    /** Selects from missing tiles, at least one, those to bake first. */
    Job next(TileSet missing);

    /**
     * Bakes tiles, or reads them from the cache.
     *
     * @return the coefficients of each tile, in the order of the tiles' numbers
     * @throws java.util.concurrent.CancellationException soon after the token is canceled; baking the same job again reuses its samples
     */
    List<byte[]> bake(Job job, CancellationToken token);

    @Override
    void close();
}
