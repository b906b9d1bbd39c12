package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Reach;
import sunbeam.precompute.plan.VisibleRange;

/**
 * Points (u, v, w) that a map or a list of directions looks up, and the tiles that hold them.
 *
 * @param reach one light with all views, or pairs of directions
 */
public record TablePoints(Reach reach) {
    // Directions of a validation: 20 times the bright ones needed, since nearly all directions of a grating are dark.
    private static final int SAMPLES = 20 * TableErrors.ENOUGH;
    private static final long SEED = 20140607;

    public TablePoints {
        if (reach instanceof Reach.Everything) {
            throw new IllegalArgumentException("a table for all directions is not limited to points");
        }
    }

    /** Returns the grid of a table for these points only. */
    public TileGrid grid(TableDesign design) {
        return reach instanceof Reach.OneLight one ? TileGrid.of(design, one.light()) : TileGrid.of(design, pairs());
    }

    private List<DirectionPair> pairs() {
        return reach instanceof Reach.Pairs some ? some.pairs() : List.of();
    }

    /** Returns the tiles of a grid that hold the points. */
    public BitSet tiles(TileGrid grid) {
        BitSet tiles = new BitSet();
        if (reach instanceof Reach.OneLight one) {
            return grid.space() instanceof TableSpace.OneLight ? grid.reachable() : grid.reachable(one.light());
        }
        TileFeedback marks = new TileFeedback(grid, tiles);
        pairs().forEach(pair -> marks.mark(pair.u(), pair.v(), pair.w()));
        return tiles;
    }

    /** Returns an upper estimate of the memory of a table for these points, and of baking it. */
    public MemoryNeed memory(TableDesign design) {
        TileGrid grid = grid(design);
        double tilesOfSlice = reach instanceof Reach.OneLight
                ? Math.PI / 4 * grid.columns() * grid.rows()
                // Each point may lie on a corner of four tiles.
                : Math.min(4.0 * pairs().size(), (double) grid.columns() * grid.rows());
        long tiles = (long) (tilesOfSlice * (grid.slices() == 1 ? 1 : Math.min(grid.slices(), TableDesign.TAPS + 1)));
        MemoryNeed arrays = MemoryNeed.of(0, List.of(AtlasPages.texels(tiles), grid.tileList(1)));
        return new MemoryNeed(
                2 * arrays.textureBytes() + 2 * LevelBaking.sampleBytes(tiles),
                arrays.textureBytes(),
                arrays.largestTextureBytes(),
                arrays.longestSide(),
                arrays.layers());
    }

    /** Returns a range that holds all texels of a table for these points. */
    public VisibleRange range(TableDesign design) {
        double margin = 2 * TileGrid.STORED_SIDE * design.step();
        if (reach instanceof Reach.OneLight one) {
            VisibleRange visible = VisibleRange.of(one.light());
            double lowest = -new TableSpace.OneLight(one.light()).uvw(TableSpace.OneLight.HORIZON + margin, 0, 0)[2];
            return new VisibleRange(
                    visible.minimumU(),
                    visible.maximumU(),
                    visible.minimumV(),
                    visible.maximumV(),
                    lowest,
                    visible.maximumW());
        }
        VisibleRange visible = VisibleRange.of(pairs());
        // Refinement makes slices closer, so that they stay within this range.
        double slices = (TableDesign.TAPS + 1) * design.sliceStep();
        return new VisibleRange(
                visible.minimumU() - margin,
                visible.maximumU() + margin,
                visible.minimumV() - margin,
                visible.maximumV() + margin,
                Math.max(0, visible.minimumW() - slices),
                Math.min(2, visible.maximumW() + slices));
    }

    /** Returns the largest |(u, v)| of a texel. */
    public double farthest() {
        return reach instanceof Reach.OneLight one
                ? 1 + Math.hypot(one.light().x(), one.light().y())
                : TableSpace.AllLights.REACH;
    }

    /** Returns directions for validation; for one light uniform on an orthographic map. */
    public List<DirectionPair> samples() {
        Random random = new Random(SEED);
        List<DirectionPair> samples = new ArrayList<>(pairs());
        Collections.shuffle(samples, random);
        if (reach instanceof Reach.OneLight one) {
            while (samples.size() < SAMPLES) {
                double x = 2 * random.nextDouble() - 1;
                double y = 2 * random.nextDouble() - 1;
                double height = 1 - x * x - y * y;
                if (height > 0) {
                    samples.add(new DirectionPair(one.light(), new Direction(x, y, Math.sqrt(height))));
                }
            }
        }
        return samples.subList(0, Math.min(samples.size(), SAMPLES));
    }

    /** Returns a text that determines the points. */
    public String key() {
        if (reach instanceof Reach.OneLight) {
            return reach.toString();
        }
        Sha256 hash = new Sha256();
        ByteBuffer bytes = ByteBuffer.allocate(3 * Double.BYTES);
        for (DirectionPair pair : pairs()) {
            bytes.clear();
            hash.add(bytes.putDouble(pair.u())
                    .putDouble(pair.v())
                    .putDouble(pair.w())
                    .flip());
        }
        return hash.hex();
    }
}
