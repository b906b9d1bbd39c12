package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.colortable.AtlasPages.TableLookUp;
import sunbeam.precompute.colortable.ValidatedTable.TablePoints;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.DirectionPairs;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.work.Progress;

class ColorTableTest {
    private static final GaussianArea ENSEMBLE = RadialBakerTest.ensemble(12e-6);

    private static double ensemble(HeightMap map, GaussianArea area, double u, double v) {
        return new ReferenceEvaluator(map, area.window(), WindowOrigin.CENTRE)
                .powers(DirectionPairs.of(u, v, -1.4), ColorTable.MIDDLE_WAVELENGTH)
                .ensemble();
    }

    @Test
    void aLevelIsTheMeanOfTheFinestOverItsSurroundings() {
        HeightMap map = Surfaces.random(24, 20, 150e-9, 400e-9, 4);
        ColorTable levels = ColorTable.within(1e-2, ENSEMBLE, map.relief(), false, 0);
        double sigma = levels.sigma();
        for (int number : new int[] {1, 2, 3}) {
            ColorTable.Level level = levels.levels().get(levels.pointLevelCount() + number);
            // Level l adds (2^l - 1) times the finest's variance.
            double added = sigma * Math.sqrt(Math.pow(2, number) - 1);
            double sum = 0;
            double weights = 0;
            for (int i = -8; i <= 8; i++) {
                for (int j = -8; j <= 8; j++) {
                    double weight = Math.exp(-0.5 * (i * i + j * j) / 4.0);
                    sum += weight * ensemble(map, ENSEMBLE, 0.21 + 0.5 * i * added, -0.13 + 0.5 * j * added);
                    weights += weight;
                }
            }
            double mean = sum / weights;
            // The sum stops at four deviations, beyond which lie 1e-4 of the weights.
            assertThat(level.scale() * ensemble(map, level.area(), 0.21, -0.13))
                    .as("level %d", number)
                    .isCloseTo(mean, within(3e-4 * mean));
        }
    }

    /** A slope shifts (u, v) by the slope times w; the width of the finest level is not added twice. */
    @Test
    void levelsOfReliefAreAsWideAsItsSlopesMoveThem() {
        ColorTable table = ColorTable.within(1e-2, ENSEMBLE, 1e-6, false, 0.07);
        assertThat(table.pointLevelCount()).isZero();
        assertThat(table.slopeVariance(0, 1.8)).isCloseTo(Math.pow(0.07 * 1.8, 2), within(1e-12));
        // At grazing directions the level's own width remains.
        double least = Math.pow(table.finestSigma(), 2) - Math.pow(table.sigma(), 2);
        assertThat(table.slopeVariance(0, 0)).isCloseTo(least, within(1e-12));
        assertThat(table.slopeVariance(1, 0)).isCloseTo(least + Math.pow(table.finestSigma(), 2), within(1e-12));
        // At the middle wavelength a level's window is that of its area.
        assertThat(table.widened(least, ColorTable.MIDDLE_WAVELENGTH).sigmaMeters())
                .isCloseTo(table.levels().get(0).area().window().sigmaMeters(), within(1e-12));
    }

    private static final TableDesign DESIGN = new TableDesign(0.01, 11);

    private static Stream<Direction> lights() {
        return Stream.of(new Direction(0, 0, 1), Direction.ofDegrees(30, 200), Direction.ofDegrees(89.9, 45));
    }

    @ParameterizedTest
    @MethodSource("lights")
    void aPlaceUnderOneLightIsThatOfItsDirection(Direction light) {
        TableSpace space = new TableSpace.OneLight(light);
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 200; i++) {
            DirectionPair pair = new DirectionPair(light, DirectionPairs.direction(random));
            double[] place = space.place(pair.u(), pair.v(), pair.w());
            double[] uvw = space.uvw(place[0], place[1], 0);
            // Newton's steps end at the rounding of doubles; w is flat there, sqrt(1e-16).
            assertThat(uvw[0]).isCloseTo(pair.u(), within(1e-8));
            assertThat(uvw[1]).isCloseTo(pair.v(), within(1e-8));
            assertThat(uvw[2]).isCloseTo(pair.w(), within(1e-7));
            assertThat(Math.hypot(place[0], place[1])).isLessThanOrEqualTo(TableSpace.OneLight.HORIZON + 1e-9);
        }
    }

    private static TablePoints of(Direction light) {
        return new TablePoints(VisibleRange.of(light));
    }

    private static TablePoints of(List<DirectionPair> pairs) {
        return new TablePoints(VisibleRange.of(pairs));
    }

    private static Stream<TablePoints> points() {
        return Stream.concat(
                lights().map(ColorTableTest::of),
                Stream.of(of(DirectionPairs.random(5)), of(DirectionPairs.random(40))));
    }

    @ParameterizedTest
    @MethodSource("points")
    void rangeAndMemoryAreEstimatedFromAbove(TablePoints points) {
        VisibleRange range = points.range(DESIGN);
        TileGrid grid = points.grid(DESIGN);
        double rounding = 1e-6;
        BitSet tiles = points.tiles(grid);
        ColorBaker checking = (places, token) -> {
            for (int i = 0; i < places.length; i += 3) {
                assertThat((double) places[i]).isBetween(range.minimumU() - rounding, range.maximumU() + rounding);
                assertThat((double) places[i + 1]).isBetween(range.minimumV() - rounding, range.maximumV() + rounding);
                assertThat((double) -places[i + 2]).isBetween(range.minimumW() - rounding, range.maximumW() + rounding);
            }
            return places;
        };
        new LevelBaking(grid, NumberFormat.FLOAT).bake(tiles, checking, Progress.NONE);
        assertThat(tiles.cardinality()).isPositive();
        assertThat(points.memory(DESIGN).textureBytes())
                .isGreaterThanOrEqualTo(AtlasPages.texels(tiles.cardinality()).bytes());
    }

    @ParameterizedTest
    @MethodSource("lights")
    void aMapFindsItsTilesInItsOwnTableAndInThatOfAllLights(Direction light) {
        SplittableRandom random = new SplittableRandom(3);
        TileGrid own = of(light).grid(DESIGN);
        TileGrid all = TileGrid.of(new ColorTable.Level(GaussianArea.STANDARD, 1, DESIGN, Interpolation.CUBIC, true));
        for (TileGrid grid : List.of(own, all)) {
            BitSet tiles = of(light).tiles(grid);
            TableLookUp table = new TableLookUp(List.of(grid), NumberFormat.FLOAT, (level, tile, index) -> {
                assertThat(tiles.get(tile)).isTrue();
                return 0;
            });
            for (int i = 0; i < 2000; i++) {
                DirectionPair pair = new DirectionPair(light, DirectionPairs.direction(random));
                table.xyz(0, pair.u(), pair.v(), pair.w());
            }
        }
    }

    @Test
    void aListFindsItsTilesAndLittleElse() {
        List<DirectionPair> pairs = DirectionPairs.random(100);
        TileGrid grid = of(pairs).grid(DESIGN);
        BitSet tiles = of(pairs).tiles(grid);
        BitSet used = new BitSet();
        TableLookUp table = new TableLookUp(List.of(grid), NumberFormat.FLOAT, (level, tile, index) -> {
            used.set(tile);
            return 0;
        });
        pairs.forEach(pair -> table.xyz(0, pair.u(), pair.v(), pair.w()));
        BitSet both = (BitSet) used.clone();
        both.and(tiles);
        assertThat(both).isEqualTo(used);
        // Of a tile's side 1 in 200 lies close to its edge.
        assertThat(tiles.cardinality()).isLessThan(used.cardinality() * 11 / 10);
    }

    @Test
    void listsThatAreSortedAreComparedAllOver() {
        Direction light = Direction.ofDegrees(20, 30);
        List<DirectionPair> pairs = IntStream.range(0, 8000)
                .mapToObj(i -> new DirectionPair(light, Direction.ofDegrees(i / 100.0, 0)))
                .toList();
        List<DirectionPair> samples = of(pairs).samples();
        assertThat(Set.copyOf(samples)).isEqualTo(Set.copyOf(pairs));
        double steepest = samples.subList(0, 2000).stream()
                .mapToDouble(pair -> pair.wr().z())
                .min()
                .orElseThrow();
        // 2,000 random ones of 8,000 miss the last hundred with a probability of 1e-12.
        assertThat(Math.toDegrees(Math.acos(steepest))).isGreaterThan(79);
    }
}
