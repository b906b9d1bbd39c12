package sunbeam.app.gpu.colors;

import java.util.BitSet;
import java.util.List;

/** Bakes tiles of a color table. For one thread at a time. */
interface TileBaker extends AutoCloseable {
    /**
     * Tiles of one level that are baked together.
     *
     * @param level of the tiles
     * @param tiles their numbers; at least one
     */
    record Job(int level, BitSet tiles) {}

    /** Selects the tiles to bake first from missing tiles, of which there is at least one. */
    Job next(TileSet missing);

    /**
     * Bakes tiles, or reads them from the cache.
     *
     * @return the coefficients of each, in the order of their numbers
     * @throws java.util.concurrent.CancellationException soon after the token is canceled; baking the same job again reuses its samples
     */
    List<byte[]> bake(Job job, CancellationToken token);

    @Override
    void close();
}
