package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableLookUp;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;

/** Random sample of a picture's footprints, at which its color table is validated. Not thread-safe. */
final class FootprintSample {
    // Most footprints of a grating are dark. 60 bright ones of the sample determine the median within a fifth of its
    // rank.
    private static final int MOST = 1000;
    private static final int ENOUGH = 60;
    private static final int COLORS = 3;
    private static final long SEED = 35;

    private final List<Footprint> chosen = new ArrayList<>();
    private SplittableRandom random = new SplittableRandom(SEED);
    private long seen;

    /** Taps of one footprint: u, v, w of each. */
    private record Footprint(int level, double[][] taps) {}

    /** Adds a random selection of these footprints. */
    void add(Footprints footprints) {
        for (int i = 0; i < footprints.count(); i++) {
            if (footprints.level(i) < 0) {
                continue;
            }
            // Reservoir sampling: each footprint so far is chosen with the same probability.
            long place = seen < MOST ? seen : random.nextLong(seen + 1);
            seen++;
            if (place < MOST) {
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

    /** Looks the chosen footprints up in a table, whose tiles must be resident. */
    Tabulated tabulated(ColorTable levels, TableLookUp table) {
        List<Lit> lit = new ArrayList<>();
        for (int i = 0; i < chosen.size() && lit.size() < ENOUGH; i++) {
            int level = chosen.get(i).level();
            double[][] taps = chosen.get(i).taps();
            double scale = levels.levels().get(level).scale();
            double[] mean = Arrays.stream(mean(taps, tap -> table.xyz(level, taps[tap][0], taps[tap][1], taps[tap][2])))
                    .map(value -> scale * value)
                    .toArray();
            if (Comparison.isBright(mean)) {
                lit.add(new Lit(level, taps, mean));
            }
        }
        return new Tabulated(levels, lit);
    }

    /** @param xyz by the number of the tap */
    private static double[] mean(double[][] taps, IntFunction<double[]> xyz) {
        double[] mean = new double[COLORS];
        for (int i = 0; i < taps.length; i++) {
            double[] color = xyz.apply(i);
            for (int c = 0; c < COLORS; c++) {
                mean[c] += color[c] / taps.length;
            }
        }
        return mean;
    }

    /**
     * A bright footprint.
     *
     * @param taps u, v, w of each
     * @param tabulated X, Y, Z of its mean
     */
    record Lit(int level, double[][] taps, double[] tabulated) {}

    /** Colors of a table at some footprints. Immutable. */
    record Tabulated(ColorTable levels, List<Lit> footprints) {
        /** @param exact colors of places of a level, before its scale */
        ErrorStatistics errors(BiFunction<Integer, float[], float[]> exact) {
            List<Comparison> compared = new ArrayList<>();
            for (int level = 0; level < levels.levels().size(); level++) {
                int number = level;
                List<Lit> some =
                        footprints.stream().filter(lit -> lit.level == number).toList();
                double scale = levels.levels().get(level).scale();
                float[] xyz = some.isEmpty() ? new float[0] : exact.apply(level, places(some));
                int first = 0;
                for (Lit lit : some) {
                    int start = first;
                    double[] mean = mean(
                            lit.taps,
                            tap -> IntStream.range(0, COLORS)
                                    .mapToDouble(c -> scale * xyz[COLORS * (start + tap) + c])
                                    .toArray());
                    compared.add(new Comparison(lit.tabulated, mean, 1));
                    first += lit.taps.length;
                }
            }
            return Comparison.relative(compared);
        }

        private static float[] places(List<Lit> footprints) {
            double[][] taps =
                    footprints.stream().flatMap(lit -> Arrays.stream(lit.taps)).toArray(double[][]::new);
            float[] places = new float[COLORS * taps.length];
            for (int i = 0; i < places.length; i++) {
                places[i] = (float) taps[i / COLORS][i % COLORS];
            }
            return places;
        }
    }
}
