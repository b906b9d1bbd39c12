package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Iterator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.work.Progress;

/** Tiles of a level: their baking, the interpolation between their texels, and the numbers that they store. */
class LevelBakingTest {
    private static final TableDesign DESIGN = new TableDesign(0.02, 5);
    private static final TileGrid GRID = grid(Interpolation.CUBIC);
    private static final TileGrid LINES = grid(Interpolation.SHIFTED_LINES);
    private static final ColorBaker WAVES = (uvw, token) -> waves(uvw);

    private static TileGrid grid(Interpolation interpolation) {
        return TileGrid.of(new ColorTable.Level(GaussianArea.STANDARD, 1, DESIGN, interpolation, true));
    }

    /** Colors whose roots are waves of 12 texels. */
    private static float[] waves(float[] uvw) {
        float[] xyz = new float[uvw.length];
        for (int i = 0; i < uvw.length; i += 3) {
            for (int c = 0; c < 3; c++) {
                xyz[i + c] = (float) Math.pow(root(uvw[i], uvw[i + 1], c) - uvw[i + 2], 2);
            }
        }
        return xyz;
    }

    private static double root(double u, double v, int color) {
        double wave = 2 * Math.PI / 0.24;
        return 3 + color + Math.sin(wave * u) * Math.cos(wave * v);
    }

    private static BitSet tilesOf(double u, double v, double w) {
        return tilesOf(GRID, u, v, w);
    }

    private static BitSet tilesOf(TileGrid grid, double u, double v, double w) {
        BitSet tiles = new BitSet();
        new TileGrid.Feedback(grid, tiles).mark(u, v, w);
        return tiles;
    }

    /** All tiles that look-ups use are among the reachable ones. */
    @Test
    void allPairsOfDirectionsAreReachable() {
        SplittableRandom random = new SplittableRandom(3);
        for (TileGrid grid : List.of(GRID, LINES)) {
            BitSet reachable = grid.reachable();
            for (int i = 0; i < 200_000; i++) {
                // Every other direction at the rim, where tiles begin.
                double angle = random.nextDouble(2 * Math.PI);
                double[] uvw = {3 * Math.cos(angle), 3 * Math.sin(angle), i % 2 == 0 ? 0 : random.nextDouble(-9, 0)};
                TableSpace.AllLights.shorten(uvw);
                BitSet beyond = tilesOf(grid, (float) uvw[0], (float) uvw[1], (float) uvw[2]);
                beyond.andNot(reachable);
                assertThat(beyond.isEmpty()).as("%s", Arrays.toString(uvw)).isTrue();
            }
        }
    }

    /** Root mean square error of roots between texels. */
    private static double error(TileGrid grid) {
        double[][] places = new SplittableRandom(6)
                .doubles(300, -1.4, 1.4)
                .mapToObj(u -> new double[] {u, 1.4 * Math.sin(1000 * u)})
                .toArray(double[][]::new);
        BitSet tiles = new BitSet();
        Arrays.stream(places).forEach(at -> tiles.or(tilesOf(grid, at[0], at[1], -0.5)));
        AtlasPages pages = new AtlasPages(List.of(grid), NumberFormat.FLOAT);
        Iterator<byte[]> baked = new LevelBaking(grid, NumberFormat.FLOAT)
                .bake(tiles, WAVES, Progress.NONE)
                .iterator();
        tiles.stream().forEach(tile -> pages.add(0, tile, baked.next()));
        double squares = 0;
        for (double[] at : places) {
            double y = pages.lookUp().xyz(0, at[0], at[1], -0.5)[1];
            squares += Math.pow(Math.sqrt(y) - root(at[0], at[1], 1) - 0.5, 2);
        }
        return Math.sqrt(squares / 300);
    }

    @Test
    void tilesAreSplinesThroughRootsOfTheirColorsOrAsCloseAsLinesCanBe() {
        // A cubic spline errs by (2 pi / 12)^4 / 384 = 2e-4 of a wave of 12 texels, each way.
        assertThat(error(GRID)).isLessThan(4e-4);
        // Blu et al.: f'' / sqrt(720) each way, of a product of waves of 12 texels whose square is 1/4 in the mean;
        // both ways bend together, so that errors add up where bends do: sqrt(2) to 2 times as much.
        double bend = Math.pow(2 * Math.PI / 12, 2) * 0.5;
        assertThat(error(LINES)).isBetween(bend / Math.sqrt(720), 2.2 * bend / Math.sqrt(720));
    }

    @Test
    void samplesBeforeACancellationAreNotEvaluatedAgain() {
        BitSet tiles = tilesOf(0.11, 0.3, -1.1);
        LevelBaking baking = new LevelBaking(GRID, NumberFormat.FLOAT, 1000);
        long all = baking.missing(tiles);
        long[] done = {0};
        ColorBaker canceled = (uvw, token) -> {
            token.step(uvw.length / 3);
            return waves(uvw);
        };
        Progress token = samples -> {
            if (done[0] > all / 2) {
                throw new CancellationException();
            }
            done[0] += samples;
        };
        assertThatThrownBy(() -> baking.bake(tiles, canceled, token)).isInstanceOf(CancellationException.class);
        assertThat(baking.missing(tiles)).isEqualTo(all - done[0]).isLessThan(3 * all / 4);
        List<byte[]> resumed = baking.bake(tiles, WAVES, Progress.NONE);
        List<byte[]> whole = new LevelBaking(GRID, NumberFormat.FLOAT).bake(tiles, WAVES, Progress.NONE);
        assertThat(resumed).containsExactlyElementsOf(whole);
    }

    @Test
    void eachSampleIsEvaluatedOnceAndTilesAreTheSameInAnyOrder() {
        BitSet left = tilesOf(0.11, 0.3, -1.1);
        BitSet right = tilesOf(0.11 + TileGrid.SIDE * DESIGN.step(), 0.3, -1.1);
        BitSet both = (BitSet) left.clone();
        both.or(right);
        LevelBaking together = new LevelBaking(GRID, NumberFormat.FLOAT);
        long all = together.missing(both);
        List<byte[]> made = together.bake(both, WAVES, Progress.NONE);
        assertThat(together.missing(both)).isZero();
        LevelBaking apart = new LevelBaking(GRID, NumberFormat.FLOAT);
        long first = apart.missing(left);
        apart.bake(left, WAVES, Progress.NONE);
        assertThat(first + apart.missing(right)).as("samples in all").isEqualTo(all);
        List<byte[]> later = apart.bake(right, WAVES, Progress.NONE);
        // Numbers of tiles ascend, as tiles do in a list.
        int[] numbers = both.stream().toArray();
        int[] ofRight =
                right.stream().map(tile -> Arrays.binarySearch(numbers, tile)).toArray();
        assertThat(later)
                .containsExactlyElementsOf(
                        Arrays.stream(ofRight).mapToObj(made::get).toList());
    }

    @Test
    void aLookUpReadsFourSlicesAndBothTilesAtAnEdge() {
        int tile = GRID.columns() / 2;
        double middle = GRID.originX() + (tile + 0.5) * TileGrid.SIDE * DESIGN.step();
        assertThat(tilesOf(middle, middle, -0.6).cardinality()).isEqualTo(TableDesign.TAPS);
        double edge = GRID.originX() + tile * TileGrid.SIDE * DESIGN.step();
        assertThat(tilesOf(edge, middle, -0.6).cardinality()).isEqualTo(2 * TableDesign.TAPS);
        assertThat(tilesOf(edge, edge, -0.6).cardinality()).isEqualTo(4 * TableDesign.TAPS);
    }

    @Test
    void noPairOfDirectionsNorAPixelsRimBeyondThemLeavesTheGrid() {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 1000; i++) {
            BitSet tiles = tilesOf(random.nextDouble(-40, 40), random.nextDouble(-2, 2), random.nextDouble(-2.4, 0.3));
            assertThat(tiles.length()).isLessThanOrEqualTo(GRID.perSlice() * GRID.slices());
            // Prefilters need the neighbors.
            tiles.stream().mapToObj(GRID::place).forEach(place -> {
                assertThat(place[0]).isBetween(1, GRID.columns() - 2);
                assertThat(place[1]).isBetween(1, GRID.columns() - 2);
            });
        }
    }

    /** By the standard's definition. */
    static double value(short half) {
        int exponent = (half >> 10) & 0x1f;
        int fraction = half & 0x3ff;
        double magnitude =
                exponent == 0 ? Math.scalb((double) fraction, -24) : Math.scalb(1024.0 + fraction, exponent - 25);
        return half < 0 ? -magnitude : magnitude;
    }

    @Test
    void roundsToTheNearestHalfAndTiesToEven() {
        SplittableRandom random = new SplittableRandom(3);
        for (int bits = 0; bits < 0x7bff; bits++) {
            double low = value((short) bits);
            double high = value((short) (bits + 1));
            assertThat(NumberFormat.half((float) low)).isEqualTo((short) bits);
            assertThat((double) NumberFormat.ofHalf((short) bits)).isEqualTo(low);
            float middle = (float) (0.5 * (low + high));
            assertThat(NumberFormat.half(middle)).isEqualTo((short) (bits + (bits & 1)));
            assertThat(NumberFormat.half(Math.nextDown(middle))).isEqualTo((short) bits);
            assertThat(NumberFormat.half(Math.nextUp(middle))).isEqualTo((short) (bits + 1));
            float some = (float) (low + (high - low) * random.nextDouble(0.51, 1));
            assertThat(NumberFormat.half(-some)).isEqualTo((short) (0x8000 | (bits + 1)));
        }
    }

    @Test
    void largerNumbersBecomeTheLargestHalf() {
        for (float large : new float[] {65504, 65519, 65520, 1e6f, Float.MAX_VALUE, Float.POSITIVE_INFINITY}) {
            assertThat(value(NumberFormat.half(large))).isEqualTo(65504);
            assertThat(value(NumberFormat.half(-large))).isEqualTo(-65504);
        }
    }

    @Test
    void rootsOfPowersFarBelowAMirrorsKeepElevenBits() {
        for (double power = 1; power > 4e-14; power *= 0.37) {
            float root = (float) Math.sqrt(power);
            float kept = NumberFormat.ofHalf(NumberFormat.half(NumberFormat.HALF.scale() * root));
            assertThat(Math.abs(kept / NumberFormat.HALF.scale() / root - 1)).isLessThanOrEqualTo(0x1p-11f);
        }
    }

    /** Tiles of an older filter of the same name are not taken for those of the present one. */
    @ParameterizedTest
    @EnumSource
    void keysContainTheFiltersImpulseResponse(Interpolation filter) {
        float[] impulse = new float[16];
        impulse[8] = 1;
        filter.toCoefficients(impulse, 16, 1);
        assertThat(filter.key()).startsWith(filter.name()).contains(Arrays.toString(impulse));
    }
}
