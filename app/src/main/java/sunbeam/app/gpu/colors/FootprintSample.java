package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

/** Random sample of a picture's footprints, at which its color table is validated. Not thread-safe. */
final class FootprintSample {
    // Most footprints in the sample, and number of bright ones that are compared: most footprints of a grating are
    // dark. The median of 60 bright ones lies between the 37th and the 63rd percentile of all bright footprints in 95 %
    // of samples.
    private static final int CAPACITY = 1000;
    private static final int ENOUGH_BRIGHT = 60;
    private static final int COMPONENTS = 3;
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
            // Reservoir sampling: each footprint so far is chosen with the same probability.
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

    /** Looks up bright footprints of the sample in a table, whose tiles must be resident. */
    Tabulated tabulated(ColorTable colorTable, Residency residency) {
        List<BrightFootprint> bright = new ArrayList<>();
        for (int i = 0; i < chosen.size() && bright.size() < ENOUGH_BRIGHT; i++) {
            int level = chosen.get(i).level();
            double[][] taps = chosen.get(i).taps();
            double scale = colorTable.levels().get(level).scale();
            double[] mean = mean(taps, tap -> residency.xyz(level, scale, taps[tap]));
            if (Comparison.isBright(mean)) {
                bright.add(new BrightFootprint(level, taps, mean));
            }
        }
        return new Tabulated(colorTable, bright);
    }

    /** @param xyz function from a tap's index to its X, Y, Z */
    private static double[] mean(double[][] taps, IntFunction<double[]> xyz) {
        double[] mean = new double[COMPONENTS];
        for (int i = 0; i < taps.length; i++) {
            double[] color = xyz.apply(i);
            for (int c = 0; c < COMPONENTS; c++) {
                mean[c] += color[c] / taps.length;
            }
        }
        return mean;
    }

    /**
     * A bright footprint.
     *
     * @param taps u, v, w of each tap
     * @param tabulated mean X, Y, Z of its taps in the table
     */
    record BrightFootprint(int level, double[][] taps, double[] tabulated) {}

    record Tabulated(ColorTable colorTable, List<BrightFootprint> footprints) {
        /**
         * @param exact function that evaluates, without table, the X, Y, Z of a level at some (u, v, w), not yet multiplied by the level's
         *     scale
         */
        ErrorStatistics errors(BiFunction<Integer, float[], float[]> exact) {
            List<Comparison> compared = new ArrayList<>();
            for (int level = 0; level < colorTable.levels().size(); level++) {
                int number = level;
                List<BrightFootprint> ofLevel = footprints.stream()
                        .filter(footprint -> footprint.level == number)
                        .toList();
                double scale = colorTable.levels().get(level).scale();
                float[] xyz = ofLevel.isEmpty() ? new float[0] : exact.apply(level, places(ofLevel));
                int first = 0;
                for (BrightFootprint footprint : ofLevel) {
                    int start = first;
                    double[] mean = mean(
                            footprint.taps,
                            tap -> IntStream.range(0, COMPONENTS)
                                    .mapToDouble(c -> scale * xyz[COMPONENTS * (start + tap) + c])
                                    .toArray());
                    compared.add(new Comparison(footprint.tabulated, mean, 1));
                    first += footprint.taps.length;
                }
            }
            return Comparison.relative(compared);
        }

        private static float[] places(List<BrightFootprint> footprints) {
            double[][] taps = footprints.stream()
                    .flatMap(footprint -> Arrays.stream(footprint.taps))
                    .toArray(double[][]::new);
            float[] places = new float[COMPONENTS * taps.length];
            for (int i = 0; i < places.length; i++) {
                places[i] = (float) taps[i / COMPONENTS][i % COMPONENTS];
            }
            return places;
        }
    }
}
