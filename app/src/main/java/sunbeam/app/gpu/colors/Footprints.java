package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.errors.Comparison;

/**
 * Footprints in (u, v, w), as shaders/include/footprint.glsl finds them.
 *
 * @param centers u, v, w and level of each footprint; level -1 where nothing is diffracted
 * @param axes change of u, v, w along the line of each footprint's evenly spread taps, and their number
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

    /** Random footprints at which a color table is validated. Not thread-safe. */
    static final class Sample {
        // Footprints, and bright ones to compare: most of a grating are dark. In 95 % of samples the median of 60 lies
        // between the 37th and the 63rd percentile of all.
        private static final int CAPACITY = 1000;
        private static final int ENOUGH_BRIGHT = 60;
        private static final long SEED = 35;

        private final List<Footprint> chosen = new ArrayList<>();
        private SplittableRandom random = new SplittableRandom(SEED);
        private long seen;

        private record Footprint(int level, double[][] taps) {}

        void add(Footprints footprints) {
            for (int i = 0; i < footprints.count(); i++) {
                if (footprints.level(i) < 0) {
                    continue;
                }
                // Reservoir sampling.
                long place = seen < CAPACITY ? seen : random.nextLong(seen + 1);
                seen++;
                if (place < CAPACITY) {
                    Footprint footprint = new Footprint(footprints.level(i), footprints.taps(i));
                    if (place < chosen.size()) {
                        chosen.set((int) place, footprint);
                    } else {
                        chosen.add(footprint);
                    }
                }
            }
        }

        void clear() {
            chosen.clear();
            random = new SplittableRandom(SEED);
            seen = 0;
        }

        /** Looks up bright footprints in a table, whose tiles must be resident, and starts a new sample. */
        List<Tabulated> drain(Residency residency) {
            List<Tabulated> bright = chosen.stream()
                    .map(footprint -> new Tabulated(
                            footprint.level, footprint.taps, residency.mean(footprint.level, footprint.taps)))
                    .filter(footprint -> Comparison.isBright(footprint.xyz))
                    .limit(ENOUGH_BRIGHT)
                    .toList();
            clear();
            return bright;
        }
    }

    /** Bright footprint in a table: u, v, w of each tap, and the mean X, Y, Z of the taps in the table. */
    record Tabulated(int level, double[][] taps, double[] xyz) {
        /** Compares with X, Y, Z of each tap without table, which begin at an index and are not yet multiplied by the level's scale. */
        Comparison compare(float[] exact, int first, double scale) {
            double[] mean = new double[COORDINATES];
            for (int i = 0; i < COORDINATES * taps.length; i++) {
                mean[i % COORDINATES] += scale * exact[first + i] / taps.length;
            }
            return new Comparison(xyz, mean, 1);
        }
    }
}
