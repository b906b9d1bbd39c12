package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;

class TableTilesTest {
    private static final TableDesign DESIGN = new TableDesign(0.01, 11);

    private static Stream<Direction> lights() {
        return Stream.of(new Direction(0, 0, 1), Direction.ofDegrees(30, 200), Direction.ofDegrees(89.9, 45));
    }

    private static Direction view(Random random) {
        double z = random.nextDouble();
        double sine = Math.sqrt(1 - z * z);
        double phi = 2 * Math.PI * random.nextDouble();
        return new Direction(sine * Math.cos(phi), sine * Math.sin(phi), z);
    }

    @ParameterizedTest
    @MethodSource("lights")
    void aPlaceUnderOneLightIsThatOfItsDirection(Direction light) {
        TableSpace space = new TableSpace.OneLight(light);
        Random random = new Random(1);
        for (int i = 0; i < 200; i++) {
            DirectionPair pair = new DirectionPair(light, view(random));
            double[] place = space.place(pair.u(), pair.v(), pair.w());
            double[] uvw = space.uvw(place[0], place[1], 0);
            // Newton's steps end at the rounding of doubles; w is flat there, sqrt(1e-16).
            assertThat(uvw[0]).isCloseTo(pair.u(), within(1e-8));
            assertThat(uvw[1]).isCloseTo(pair.v(), within(1e-8));
            assertThat(uvw[2]).isCloseTo(pair.w(), within(1e-7));
            assertThat(Math.hypot(place[0], place[1])).isLessThanOrEqualTo(TableSpace.OneLight.HORIZON + 1e-9);
        }
    }

    @Test
    void nowhereDoUAndVChangeFasterThanTheirPlaces() {
        TableSpace space = new TableSpace.OneLight(Direction.ofDegrees(20, 10));
        double step = 1e-4;
        for (double x = -1.25; x <= 1.25; x += 0.05) {
            for (double y = -1.25; y <= 1.25; y += 0.05) {
                double[] here = space.uvw(x, y, 0);
                double[] right = space.uvw(x + step, y, 0);
                double[] below = space.uvw(x, y + step, 0);
                // 1e-3: the slope's own change over a step.
                assertThat(Math.hypot(right[0] - here[0], right[1] - here[1])).isLessThan(step * 1.001);
                assertThat(Math.hypot(below[0] - here[0], below[1] - here[1])).isLessThan(step * 1.001);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("lights")
    void allThatIsEvaluatedForALightLiesInTheRangeThatIsPlannedFor(Direction light) {
        requireInRange(TableTiles.of(DESIGN, light));
    }

    @Test
    void allThatIsEvaluatedForPairsLiesInTheRangeThatIsPlannedFor() {
        requireInRange(TableTiles.of(DESIGN, pairs(5)));
    }

    private static void requireInRange(TableTiles tiles) {
        VisibleRange range = tiles.range();
        double rounding = 1e-9;
        for (int number : tiles.numbers()) {
            for (int slice = 0; slice < tiles.slices(); slice++) {
                int s = slice;
                tiles.mask(number, slice).stream().forEach(index -> {
                    double[] uvw = tiles.uvw(number, s, index);
                    assertThat(uvw[0]).isBetween(range.minimumU() - rounding, range.maximumU() + rounding);
                    assertThat(uvw[1]).isBetween(range.minimumV() - rounding, range.maximumV() + rounding);
                    assertThat(-uvw[2]).isBetween(range.minimumW() - rounding, range.maximumW() + rounding);
                });
            }
        }
    }

    private static List<DirectionPair> pairs(int count) {
        Random random = new Random(2);
        List<DirectionPair> pairs = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            pairs.add(new DirectionPair(view(random), view(random)));
        }
        return pairs;
    }

    @Test
    void everyLookUpFindsItsTexelsEvaluatedWithTheirMargin() {
        List<DirectionPair> pairs = pairs(100);
        TableTiles tiles = TableTiles.of(DESIGN, pairs);
        // The first of them along an axis lies on a texel: moved on a little, all see four by four.
        double offset = 1e-6 * DESIGN.step();
        for (DirectionPair pair : pairs) {
            int column = tile(pair.u() - tiles.originX() + offset, tiles);
            int number = tile(pair.v() - tiles.originY() + offset, tiles) * tiles.columns() + column;
            BitSet mask = tiles.mask(number, firstSlice(tiles, pair));
            int side = tiles.evaluatedSide();
            int texels = 0;
            for (int index = mask.nextSetBit(0); index >= 0; index = mask.nextSetBit(index + 1)) {
                double[] uvw = tiles.uvw(number, firstSlice(tiles, pair), index);
                boolean counts = Math.abs(uvw[0] - pair.u() - offset) < 2 * DESIGN.step()
                        && Math.abs(uvw[1] - pair.v() - offset) < 2 * DESIGN.step();
                texels += counts ? 1 : 0;
                if (counts) {
                    for (int margin = 1; margin <= TableTiles.MARGIN; margin++) {
                        assertThat(mask.get(index - margin)).isTrue();
                        assertThat(mask.get(index + margin * side)).isTrue();
                    }
                }
            }
            assertThat(texels).isEqualTo(16);
        }
    }

    private static int tile(double length, TableTiles tiles) {
        return (int) Math.floor(length / DESIGN.step() / tiles.side());
    }

    private static int firstSlice(TableTiles tiles, DirectionPair pair) {
        int below = (int) Math.floor(-pair.w() / DESIGN.sliceStep());
        return Math.max(0, Math.min(below - 1, tiles.slices() - TableDesign.TAPS));
    }

    @Test
    void aShorterWindowADeeperReliefAndAToleranceAreFollowed() {
        GaussianArea ensemble = GaussianArea.STANDARD.with(Average.ENSEMBLE);
        CoherenceWindow shorter = CoherenceWindow.ofCoherenceLength(6.5e-6);
        TableDesign standard = TableDesign.within(1e-3, ensemble, 0.4e-6);
        TableDesign wide = TableDesign.within(1e-3, ensemble.with(shorter), 0.4e-6);
        assertThat(wide.step()).isCloseTo(10 * standard.step(), within(1e-12));
        // Zeros between speckles, which one coherence area has.
        assertThat(TableDesign.within(1e-3, GaussianArea.STANDARD.with(shorter), 0.4e-6)
                        .step())
                .isLessThan(0.75 * wide.step());
        assertThat(TableDesign.within(1e-4, ensemble, 0.4e-6).step()).isLessThan(0.7 * standard.step());
        assertThat(TableDesign.within(1e-3, ensemble, 4e-6).slices()).isGreaterThan(4 * standard.slices());
    }

    @Test
    void aGratingOfTwoHeightsIsDeeperThanAScanOfTheSameRelief() {
        double[] ridges = new double[64];
        double[] spike = new double[64];
        for (int i = 0; i < ridges.length; i++) {
            ridges[i] = i % 8 < 4 ? 0 : 1e-6;
        }
        spike[3] = 1e-6;
        HeightMap grating = new HeightMap(8, 8, 1e-6, 1e-6, ridges);
        HeightMap scan = new HeightMap(8, 8, 1e-6, 1e-6, spike);
        assertThat(TableDesign.depth(scan)).isCloseTo(1e-6, within(0.1e-6));
        // Its power along w is a cosine whose phase the whole relief turns; measured, slices 4 times closer are needed.
        assertThat(TableDesign.depth(grating)).isCloseTo(4.25e-6, within(0.01e-6));
    }

    @Test
    void differentLightsStepsAndPairsHaveDifferentKeys() {
        Stream<String> keys = Stream.of(
                TableTiles.of(DESIGN, new Direction(0, 0, 1)).key(),
                TableTiles.of(DESIGN, Direction.ofDegrees(1, 0)).key(),
                TableTiles.of(new TableDesign(0.011, 11), new Direction(0, 0, 1))
                        .key(),
                TableTiles.of(DESIGN, pairs(5)).key(),
                TableTiles.of(DESIGN, pairs(6)).key());
        assertThat(keys).doesNotHaveDuplicates();
    }
}
