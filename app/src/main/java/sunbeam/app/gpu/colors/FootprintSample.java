package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.FootprintErrors;
import sunbeam.precompute.colortable.TableLookUp;
import sunbeam.precompute.colortable.TableSpace;

/** Some of a picture's footprints, evenly chosen: there its table is validated. Belongs to a thread. */
final class FootprintSample {
    // Most of a grating's are dark: of so many those are taken that have light, until there are enough for a median
    // that
    // is known within a fifth of its rank.
    private static final int MOST = 1000;
    private static final int ENOUGH = 60;
    private static final int CHANNELS = 4;
    private static final int COLORS = 3;
    private static final int WEIGHT = 3;
    // So many taps of one footprint cost as much as all others.
    private static final int MOST_TAPS = 64;
    private static final long SEED = 35;

    private final List<Footprint> chosen = new ArrayList<>();
    private SplittableRandom random = new SplittableRandom(SEED);
    private long seen;

    /**
     * A footprint, as shaders/footprints.frag has it.
     *
     * @param middle u, v, w and level
     * @param wide change of u, v, w along the major axis, and taps
     * @param narrow change of u, v, w along the minor axis, and taps
     * @param edges ratio of the trapezoid's edges
     */
    private record Footprint(float[] middle, float[] wide, float[] narrow, float edges) {
        int level() {
            return (int) middle[3];
        }

        int columns() {
            return (int) wide[3];
        }

        int rows() {
            return (int) narrow[3];
        }

        /** Of the taps of a column; shaders/method/table_levels.glsl has the same. */
        double weight(double t) {
            double shorter = 0.5 * Math.min(edges, 0.999);
            return Math.max(0, Math.min(1, (0.5 - Math.abs(t)) / (0.5 - shorter)));
        }

        /** u, v, w and weight of each. */
        double[][] taps() {
            double[][] taps = new double[columns() * rows()][CHANNELS];
            for (int i = 0; i < taps.length; i++) {
                int column = i / rows();
                double t = (column + 0.5) / columns() - 0.5;
                double s = (i % rows() + 0.5) / rows() - 0.5;
                for (int axis = 0; axis < COLORS; axis++) {
                    taps[i][axis] = middle[axis] + t * wide[axis] + s * narrow[axis];
                }
                TableSpace.AllLights.within(taps[i]);
                taps[i][WEIGHT] = weight(t);
            }
            return taps;
        }
    }

    /** Takes up some of these; parameters as of {@link LevelTiles#note}. */
    void note(float[] places, float[] wide, float[] narrow, float[] edges, int count, IntUnaryOperator at) {
        for (int i = 0; i < count; i++) {
            int from = at.applyAsInt(i);
            int columns = (int) wide[from + 3];
            int rows = (int) narrow[from + 3];
            if (places[from + 3] < 0 || columns * rows > MOST_TAPS) {
                continue;
            }
            // Each of those seen so far is chosen with the same chance.
            long place = seen < MOST ? seen : random.nextLong(seen + 1);
            seen++;
            if (place < MOST) {
                Footprint footprint =
                        new Footprint(texel(places, from), texel(wide, from), texel(narrow, from), edges[from]);
                if (place < chosen.size()) {
                    chosen.set((int) place, footprint);
                } else {
                    chosen.add(footprint);
                }
            }
        }
    }

    private static float[] texel(float[] texels, int from) {
        return Arrays.copyOfRange(texels, from, from + CHANNELS);
    }

    void clear() {
        chosen.clear();
        random = new SplittableRandom(SEED);
        seen = 0;
    }

    boolean isEmpty() {
        return chosen.isEmpty();
    }

    /** What a table, whose tiles exist, has at what was chosen. */
    Tabulated tabulated(ColorTable levels, TableLookUp table) {
        List<Lit> lit = new ArrayList<>();
        for (int i = 0; i < chosen.size() && lit.size() < ENOUGH; i++) {
            int level = chosen.get(i).level();
            double[][] taps = chosen.get(i).taps();
            double scale = levels.levels().get(level).scale();
            double[] mean = Arrays.stream(mean(taps, tap -> table.xyz(level, taps[tap][0], taps[tap][1], taps[tap][2])))
                    .map(value -> scale * value)
                    .toArray();
            if (FootprintErrors.isBright(mean)) {
                lit.add(new Lit(level, taps, mean));
            }
        }
        return new Tabulated(levels, lit);
    }

    /** @param xyz by the number of the tap */
    private static double[] mean(double[][] taps, IntFunction<double[]> xyz) {
        double[] mean = new double[COLORS];
        double weights = 0;
        for (int i = 0; i < taps.length; i++) {
            double[] color = xyz.apply(i);
            for (int c = 0; c < COLORS; c++) {
                mean[c] += taps[i][WEIGHT] * color[c];
            }
            weights += taps[i][WEIGHT];
        }
        for (int c = 0; c < COLORS; c++) {
            mean[c] /= weights;
        }
        return mean;
    }

    /**
     * A footprint that has light.
     *
     * @param taps u, v, w and weight of each
     * @param tabulated X, Y, Z of its mean
     */
    record Lit(int level, double[][] taps, double[] tabulated) {}

    /** What a table has at some footprints. Immutable. */
    record Tabulated(ColorTable levels, List<Lit> footprints) {
        /** @param exact colors of places of a level, before its scale */
        FootprintErrors errors(BiFunction<Integer, float[], float[]> exact) {
            List<double[]> computed = new ArrayList<>();
            List<double[]> means = new ArrayList<>();
            for (int level = 0; level < levels.levels().size(); level++) {
                int number = level;
                List<Lit> some =
                        footprints.stream().filter(lit -> lit.level == number).toList();
                double scale = levels.levels().get(level).scale();
                float[] xyz = some.isEmpty() ? new float[0] : exact.apply(level, places(some));
                int first = 0;
                for (Lit lit : some) {
                    int start = first;
                    computed.add(lit.tabulated);
                    means.add(mean(
                            lit.taps,
                            tap -> IntStream.range(0, COLORS)
                                    .mapToDouble(c -> scale * xyz[COLORS * (start + tap) + c])
                                    .toArray()));
                    first += lit.taps.length;
                }
            }
            return FootprintErrors.of(computed, means);
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
