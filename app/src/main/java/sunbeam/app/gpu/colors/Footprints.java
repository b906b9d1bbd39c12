package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

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

        /** @param taps u, v, w of each tap */
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

        boolean isEmpty() {
            return chosen.isEmpty();
        }

        /** Looks up bright footprints in a table, whose tiles must be resident. */
        Tabulated tabulated(ColorTable colorTable, Residency residency) {
            List<BrightFootprint> bright = new ArrayList<>();
            for (int i = 0; i < chosen.size() && bright.size() < ENOUGH_BRIGHT; i++) {
                int level = chosen.get(i).level();
                double[][] taps = chosen.get(i).taps();
                double scale = colorTable.levels().get(level).scale();
                double[] mean = new double[COORDINATES];
                for (double[] tap : taps) {
                    double[] xyz = residency.xyz(level, scale, tap);
                    Arrays.setAll(mean, c -> mean[c] + xyz[c] / taps.length);
                }
                if (Comparison.isBright(mean)) {
                    bright.add(new BrightFootprint(level, taps, mean));
                }
            }
            return new Tabulated(colorTable, bright);
        }

        /** @param tabulated mean X, Y, Z of the taps in the table */
        record BrightFootprint(int level, double[][] taps, double[] tabulated) {}

        record Tabulated(ColorTable colorTable, List<BrightFootprint> footprints) {
            /** @param exact X, Y, Z of a level at some (u, v, w) without table, not yet multiplied by the level's scale */
            ErrorStatistics errors(BiFunction<Integer, float[], float[]> exact) {
                List<Comparison> compared = new ArrayList<>();
                footprints.stream()
                        .collect(Collectors.groupingBy(BrightFootprint::level))
                        .forEach((level, ofLevel) -> {
                            double scale = colorTable.levels().get(level).scale();
                            float[] xyz = exact.apply(level, places(ofLevel));
                            int first = 0;
                            for (BrightFootprint footprint : ofLevel) {
                                double[] mean = new double[COORDINATES];
                                int numbers = COORDINATES * footprint.taps.length;
                                for (int i = 0; i < numbers; i++) {
                                    mean[i % COORDINATES] += scale * xyz[first + i] / footprint.taps.length;
                                }
                                compared.add(new Comparison(footprint.tabulated, mean, 1));
                                first += numbers;
                            }
                        });
                return Comparison.relative(compared);
            }

            private static float[] places(List<BrightFootprint> footprints) {
                double[][] taps = footprints.stream()
                        .flatMap(footprint -> Arrays.stream(footprint.taps))
                        .toArray(double[][]::new);
                float[] places = new float[COORDINATES * taps.length];
                for (int i = 0; i < places.length; i++) {
                    places[i] = (float) taps[i / COORDINATES][i % COORDINATES];
                }
                return places;
            }
        }
    }
}
