package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.colortable.ValidatedTable.TablePoints;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.DirectionPairs;
import sunbeam.precompute.work.Progress;

/** Tables checked at directions between their samples. */
class ValidatedTableTest {
    private static final Direction LIGHT = Direction.ofDegrees(20, 30);
    private static final TableDesign COARSE = new TableDesign(0.04, 11);
    private static final double TOLERANCE = 1e-2;

    private static final TablePoints ONE_LIGHT = new TablePoints(VisibleRange.of(LIGHT));

    private final List<String> messages = new ArrayList<>();
    private int opened;
    private boolean hasRoom = true;

    /** Power of two orders that cancel on lines: it is smooth, but its root has a kink. */
    private static final ColorBaker CANCELLING = baker((u, v, w) -> Math.pow(Math.sin(9 * u + 4 * v + w), 2) + 1e-7);

    private static final ColorBaker SMOOTH = baker((u, v, w) -> 2 + Math.sin(u + v) + 0.1 * w);

    private interface Power {
        double at(double u, double v, double w);
    }

    private static ColorBaker baker(Power power) {
        return (uvw, token) -> {
            float[] xyz = new float[uvw.length];
            for (int i = 0; i < uvw.length; i += 3) {
                Arrays.fill(xyz, i, i + 3, (float) power.at(uvw[i], uvw[i + 1], uvw[i + 2]));
            }
            return xyz;
        };
    }

    private ValidatedTable make(double tolerance, TablePoints points, TableDesign coarsest, ColorBaker baker) {
        Function<TableDesign, ColorBaker> bakers = design -> {
            opened++;
            return baker;
        };
        return ValidatedTable.make(
                tolerance,
                points,
                coarsest,
                bakers,
                samples -> Progress.NONE,
                need -> hasRoom,
                design -> {
                    throw new IllegalStateException("no room for " + design.step());
                },
                new ValidatedTable.Diagnostics(messages::add, messages::add));
    }

    private ValidatedTable oneLight(ColorBaker baker) {
        return make(TOLERANCE, ONE_LIGHT, COARSE, baker);
    }

    @Test
    void twoOfAHundredThatErrByMoreThanFiveMayAreTooMany() {
        for (double percentile98 : new double[] {2.9e-3, 3.1e-3}) {
            ErrorStatistics errors = new ErrorStatistics(2000, 1e-4, 1e-3, percentile98, 1, 1e-3);
            boolean kept = new ValidatedTable(null, errors).excess(1e-3) <= 1;
            assertThat(kept).isEqualTo(percentile98 < 3e-3);
        }
    }

    @Test
    void aTableThatKeepsItsToleranceIsMadeOnce() {
        ValidatedTable made = oneLight(SMOOTH);
        assertThat(made.grid().design()).isEqualTo(COARSE);
        assertThat(opened).isOne();
        assertThat(messages).isEmpty();
        assertThat(made.words(TOLERANCE)).contains("checked at ", " directions: errors relative to its source of ");
    }

    @Test
    void kinksOfRootsMakeStepsSmallerUntilTheToleranceIsKept() {
        ValidatedTable made = oneLight(CANCELLING);

        assertThat(made.grid().design().step()).isLessThan(COARSE.step());
        assertThat(messages).isNotEmpty().allMatch(line -> line.contains("baked again in steps of"));
        List<Double> errors = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(11);
        while (errors.size() < 1000) {
            // Directions other than the checked ones.
            DirectionPair pair = new DirectionPair(LIGHT, DirectionPairs.direction(random));
            float exact = CANCELLING.bake(uvw(pair), Progress.NONE)[1];
            errors.add(Math.abs(xyz(made, pair)[1] - exact) / exact);
        }
        errors.sort(null);
        assertThat(errors.get(500)).isLessThan(TOLERANCE);
        assertThat(errors.get(950)).isLessThan(3 * TOLERANCE);
    }

    private static float[] uvw(DirectionPair pair) {
        return new float[] {(float) pair.u(), (float) pair.v(), (float) pair.w()};
    }

    private static double[] xyz(ValidatedTable made, DirectionPair pair) {
        return made.pages().lookUp().xyz(0, pair.u(), pair.v(), pair.w());
    }

    @Test
    void pairsHaveFinerSlicesToo() {
        List<DirectionPair> pairs = DirectionPairs.random(60);
        ColorBaker deep = baker((u, v, w) -> 1.5 + Math.sin(14 * w));

        TablePoints points = new TablePoints(VisibleRange.of(pairs));
        ValidatedTable made = make(TOLERANCE, points, COARSE, deep);

        assertThat(made.grid().slices()).isGreaterThan(COARSE.slices());
        for (DirectionPair pair : pairs) {
            double exact = 1.5 + Math.sin(14 * pair.w());
            // All pairs were checked; beyond the 95th percentile a polynomial errs by little more.
            assertThat(xyz(made, pair)[0]).isCloseTo(exact, within(6 * TOLERANCE * exact));
        }
    }

    @Test
    void darkDirectionsNeedNoFinerTable() {
        assertThat(oneLight(baker((u, v, w) -> 1e-12 * (1 + Math.sin(1000 * u))))
                        .grid()
                        .design())
                .isEqualTo(COARSE);
        assertThat(messages).isEmpty();
    }

    @Test
    void tablesWithoutRoomAreRefusedBeforehand() {
        hasRoom = false;
        assertThatThrownBy(() -> oneLight(CANCELLING)).hasMessageContaining("no room for");
        assertThat(opened).isOne();
        assertThat(messages).isEmpty();
    }

    @Test
    void aTableThatKeepsThePromiseIsNotRefusedForLackOfRoomToBeSurer() {
        // Its errors lie between the table's target and its tolerance.
        ColorBaker nearly = baker((u, v, w) -> 1 + 0.5 * Math.sin(36 * u));

        hasRoom = false;
        ValidatedTable made = oneLight(nearly);

        assertThat(made.grid().design()).isEqualTo(COARSE);
        assertThat(messages).singleElement().asString().contains("memory does not suffice");
    }

    @Test
    void noiseAndNanEndRefinement() {
        Random random = new Random(3);
        oneLight(baker((u, v, w) -> 1 + random.nextDouble()));
        assertThat(messages).last().asString().contains("smaller steps do not help");
        messages.clear();
        opened = 0;
        oneLight(baker((u, v, w) -> u > 0.2 ? Double.NaN : 1.0));
        assertThat(opened).isOne();
        assertThat(messages).singleElement().asString().contains("smaller steps do not help");
    }

    @Test
    void lightWhereThereShouldBeNoneCounts() {
        // The spline through the root of a lone sharp order rings beside it.
        ColorBaker lone = baker((u, v, w) -> order(u, v));
        TableDesign coarser = new TableDesign(0.1, 11);
        ValidatedTable made = make(1e9, ONE_LIGHT, coarser, lone);
        long bright = ONE_LIGHT.samples().stream()
                .filter(pair -> order(pair.u(), pair.v()) > 1e-9)
                .count();
        assertThat((long) made.errors().count()).isGreaterThan(bright);
    }

    private static double order(double u, double v) {
        return Math.exp(-400 * (u * u + v * v));
    }

    /** The table of one light from cached tiles of {@link #SMOOTH}, checked against a baker. */
    private static Optional<ValidatedTable> lookUp(ColorTable levels, BitSet missing, ColorBaker baker) {
        CachedTiles cached = new CachedTiles() {
            @Override
            public BitSet present(int level, BitSet tiles) {
                BitSet present = (BitSet) tiles.clone();
                present.andNot(missing);
                return present;
            }

            @Override
            public Map<Integer, byte[]> read(int level, BitSet tiles) {
                List<byte[]> made = new LevelBaking(TileGrid.of(levels.levels().get(0)), levels.numbers())
                        .bake(tiles, SMOOTH, Progress.NONE);
                int[] numbers = tiles.stream().toArray();
                return IntStream.range(0, numbers.length).boxed().collect(Collectors.toMap(i -> numbers[i], made::get));
            }
        };
        return ValidatedTable.cached(levels, ONE_LIGHT, cached, design -> baker, samples -> Progress.NONE);
    }

    @Test
    void mapsUseCachedTilesOfAllLightsUnlessTilesAreMissingOrErr() {
        ColorTable levels = ColorTable.within(TOLERANCE, RadialBakerTest.ensemble(6e-6), 0.3e-6, false, 0);
        ColorBaker other = baker((u, v, w) -> 3 + Math.sin(u));
        BitSet tiles = ONE_LIGHT.tiles(TileGrid.of(levels.levels().get(0)));
        BitSet one = new BitSet();
        one.set(tiles.nextSetBit(tiles.length() / 2));

        ValidatedTable found = lookUp(levels, new BitSet(), SMOOTH).orElseThrow();
        assertThat(found.grid().slices()).isEqualTo(levels.slices());
        DirectionPair pair = new DirectionPair(LIGHT, Direction.ofDegrees(50, 200));
        double exact = SMOOTH.bake(uvw(pair), Progress.NONE)[0];
        assertThat(xyz(found, pair)[0]).isCloseTo(exact, within(TOLERANCE * exact));
        assertThat(lookUp(levels, one, SMOOTH)).isEmpty();
        assertThat(lookUp(levels, new BitSet(), other)).isEmpty();
    }
}
