package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.plan.GaussianArea;

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

    /** The spline through a tile's coefficients, by its definition. */
    private static double spline(float[] tile, double x, double y, int color) {
        double sum = 0;
        for (int row = (int) Math.floor(y) - 1; row <= Math.floor(y) + 2; row++) {
            for (int column = (int) Math.floor(x) - 1; column <= Math.floor(x) + 2; column++) {
                int texel = (row + 1) * TileGrid.STORED_SIDE + column + 1;
                sum += tile[4 * texel + color] * basis(x - column) * basis(y - row);
            }
        }
        return sum;
    }

    private static double basis(double distance) {
        double d = Math.abs(distance);
        return d >= 2 ? 0 : d >= 1 ? Math.pow(2 - d, 3) / 6 : 2.0 / 3 - d * d + d * d * d / 2;
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

    @Test
    void aTileIsASplineThroughRootsOfItsColors() {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 30; i++) {
            double u = random.nextDouble(-1.4, 1.4);
            double v = random.nextDouble(-1.4, 1.4);
            BitSet one = new BitSet();
            one.set(tilesOf(u, v, -0.5).nextSetBit(0));
            List<byte[]> baked = new LevelBaking(GRID, NumberFormat.FLOAT).bake(one, WAVES, BakeToken.NONE);
            int[] place = GRID.place(one.nextSetBit(0));
            double x = (u - GRID.originX()) / DESIGN.step() - place[0] * TileGrid.SIDE;
            double y = (v - GRID.originX()) / DESIGN.step() - place[1] * TileGrid.SIDE;
            if (x < 0 || y < 0 || x >= TileGrid.SIDE || y >= TileGrid.SIDE) {
                continue; // the neighboring tile, of a place close to the edge
            }
            double slice = place[2] * DESIGN.sliceStep();
            // A cubic spline errs by (2 pi / 12)^4 / 384 = 2e-4 of a wave of 12 texels, each way.
            assertThat(spline(NumberFormatTest.decoded(baked.get(0), NumberFormat.FLOAT), x, y, 1))
                    .isCloseTo(root(u, v, 1) + slice, within(6e-4));
        }
    }

    /** Lines between a tile's coefficients, by their definition. */
    private static double lines(float[] tile, double x, double y, int color) {
        double sum = 0;
        for (int row = (int) Math.floor(y); row <= Math.floor(y) + 1; row++) {
            for (int column = (int) Math.floor(x); column <= Math.floor(x) + 1; column++) {
                int texel = (row + 1) * TileGrid.STORED_SIDE + column + 1;
                sum += tile[4 * texel + color] * (1 - Math.abs(x - column)) * (1 - Math.abs(y - row));
            }
        }
        return sum;
    }

    @Test
    void aTileOfLinesIsAsCloseToItsColorsRootsAsLinesCanBe() {
        SplittableRandom random = new SplittableRandom(6);
        double squares = 0;
        int count = 0;
        while (count < 300) {
            double u = random.nextDouble(-1.4, 1.4);
            double v = random.nextDouble(-1.4, 1.4);
            int[] numbers = tilesOf(LINES, u, v, -0.5).stream().toArray();
            if (numbers.length != TableDesign.TAPS) {
                continue; // close to an edge
            }
            BitSet one = new BitSet();
            one.set(numbers[0]);
            byte[] baked = new LevelBaking(LINES, NumberFormat.FLOAT)
                    .bake(one, WAVES, BakeToken.NONE)
                    .get(0);
            float[] tile = NumberFormatTest.decoded(baked, NumberFormat.FLOAT);
            int[] place = LINES.place(numbers[0]);
            double x = (u - LINES.firstX()) / DESIGN.step() - place[0] * TileGrid.SIDE;
            double y = (v - LINES.firstX()) / DESIGN.step() - place[1] * TileGrid.SIDE;
            assertThat(x).isBetween(0.0, (double) TileGrid.SIDE);
            squares += Math.pow(lines(tile, x, y, 1) - root(u, v, 1) - place[2] * DESIGN.sliceStep(), 2);
            count++;
        }
        // Blu et al.: f'' / sqrt(720) each way, of a product of waves of 12 texels whose square is 1/4 in the mean;
        // both ways bend together, so that errors add up where bends do: sqrt(2) to 2 times as much.
        double bend = Math.pow(2 * Math.PI / 12, 2) * 0.5;
        assertThat(Math.sqrt(squares / count)).isBetween(bend / Math.sqrt(720), 2.2 * bend / Math.sqrt(720));
    }

    @Test
    void linesDependOnNoSampleBehindTheTile() {
        BitSet tile = tilesOf(LINES, 0.11, 0.3, -1.1);
        assertThat(new LevelBaking(LINES, NumberFormat.FLOAT).missing(tile))
                .isLessThan(new LevelBaking(GRID, NumberFormat.FLOAT).missing(tile));
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
        BakeToken token = samples -> {
            if (done[0] > all / 2) {
                throw new CancellationException();
            }
            done[0] += samples;
        };
        assertThatThrownBy(() -> baking.bake(tiles, canceled, token)).isInstanceOf(CancellationException.class);
        assertThat(baking.missing(tiles)).isEqualTo(all - done[0]).isLessThan(3 * all / 4);
        List<byte[]> resumed = baking.bake(tiles, WAVES, BakeToken.NONE);
        List<byte[]> whole = new LevelBaking(GRID, NumberFormat.FLOAT).bake(tiles, WAVES, BakeToken.NONE);
        assertThat(resumed).containsExactlyElementsOf(whole);
    }

    @Test
    void eachSampleIsEvaluatedOnceAndTilesAreTheSameInAnyOrder() {
        BitSet left = tilesOf(0.11, 0.3, -1.1);
        BitSet right = tilesOf(0.11 + TileGrid.SIDE * DESIGN.step(), 0.3, -1.1);
        BitSet both = new BitSet();
        both.or(left);
        both.or(right);
        LevelBaking together = new LevelBaking(GRID, NumberFormat.FLOAT);
        long all = together.missing(both);
        List<byte[]> made = together.bake(both, WAVES, BakeToken.NONE);
        assertThat(together.missing(both)).isZero();
        LevelBaking apart = new LevelBaking(GRID, NumberFormat.FLOAT);
        long first = apart.missing(left);
        apart.bake(left, WAVES, BakeToken.NONE);
        assertThat(first + apart.missing(right)).as("samples in all").isEqualTo(all);
        List<byte[]> later = apart.bake(right, WAVES, BakeToken.NONE);
        int[] numbers = both.stream().toArray();
        int[] ofRight = right.stream().toArray();
        for (int i = 0; i < ofRight.length; i++) {
            int at = Arrays.binarySearch(numbers, ofRight[i]);
            assertThat(later.get(i)).isEqualTo(made.get(at));
        }
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
        for (double angle = 0; angle < 6.3; angle += 0.1) {
            for (double length : new double[] {2, 2.5, 40}) {
                for (double w : new double[] {0.3, 0, -2, -2.4}) {
                    BitSet tiles = tilesOf(length * Math.cos(angle), length * Math.sin(angle), w);
                    assertThat(tiles.length()).isLessThanOrEqualTo(GRID.perSlice() * GRID.slices());
                    // Prefilters need the neighbors.
                    tiles.stream().forEach(tile -> {
                        int[] place = GRID.place(tile);
                        assertThat(place[0]).isBetween(1, GRID.columns() - 2);
                        assertThat(place[1]).isBetween(1, GRID.columns() - 2);
                    });
                }
            }
        }
    }
}
