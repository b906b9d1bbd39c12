package sunbeam.app.gpu.colors;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.colortable.TileGrid;

/**
 * Footprints of samples in (u, v, w), as shaders/include/footprint.glsl finds them.
 *
 * @param centers u, v, w and level of each footprint; level -1 where nothing is diffracted
 * @param axes for each footprint the change of u, v, w along the line over which its taps are spread evenly, and the number of taps
 */
public record Footprints(float[] centers, float[] axes) {
    private static final int CHANNELS = 4;
    private static final int COORDINATES = 3;
    // Footprints per parallel task, about a millisecond.
    private static final int BATCH = 1 << 10;

    int count() {
        return centers.length / CHANNELS;
    }

    int level(int footprint) {
        return (int) centers[CHANNELS * footprint + COORDINATES];
    }

    double[][] taps(int footprint) {
        double[][] taps = new double[(int) axes[CHANNELS * footprint + COORDINATES]][COORDINATES];
        for (int tap = 0; tap < taps.length; tap++) {
            double at = (tap + 0.5) / taps.length - 0.5;
            for (int axis = 0; axis < COORDINATES; axis++) {
                int i = CHANNELS * footprint + axis;
                taps[tap][axis] = centers[i] + at * axes[i];
            }
            TableSpace.AllLights.shorten(taps[tap]);
        }
        return taps;
    }

    /** Returns the tiles that the taps of all footprints read. */
    TileSet tiles(List<TileGrid> grids) {
        TileSet all = TileSet.none(grids.size());
        IntStream.range(0, (count() + BATCH - 1) / BATCH)
                .parallel()
                .mapToObj(batch -> tiles(grids, batch * BATCH, Math.min(count(), (batch + 1) * BATCH)))
                .forEachOrdered(all::add);
        return all;
    }

    private TileSet tiles(List<TileGrid> grids, int first, int end) {
        TileSet tiles = TileSet.none(grids.size());
        List<TileGrid.Feedback> feedback = IntStream.range(0, grids.size())
                .mapToObj(level -> new TileGrid.Feedback(grids.get(level), tiles.of(level)))
                .toList();
        for (int i = first; i < end; i++) {
            if (level(i) >= 0) {
                for (double[] tap : taps(i)) {
                    feedback.get(level(i)).mark(tap[0], tap[1], tap[2]);
                }
            }
        }
        return tiles;
    }
}
