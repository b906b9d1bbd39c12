package sunbeam.app.gpu.colors;

import java.util.BitSet;
import java.util.List;

/** Makes tiles of a color table; one thread at a time. */
interface TileMaker extends AutoCloseable {
    /**
     * Tiles that are made together.
     *
     * @param level of the tiles
     * @param tiles their numbers; at least one
     */
    record Job(int level, BitSet tiles) {}

    /** What is made first of tiles that are missing, of which there is at least one. */
    Job next(TileSet missing);

    /**
     * Makes tiles, or reads them where they are cached.
     *
     * @return the coefficients of each, in the order of their numbers
     * @throws java.util.concurrent.CancellationException soon after the token is canceled; the same job takes less time then
     */
    List<byte[]> make(Job job, CancellationToken token);

    @Override
    void close();
}
