package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import sunbeam.precompute.colortable.TileGrid.TableSpace;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.ArrayLayout;

/** Points (u, v, w) that a map or a list of directions looks up, and the tiles that hold them: one light with all views, or pairs. */
public record TablePoints(VisibleRange visible) {
    // 20 times the bright directions needed, since nearly all directions of a grating are dark.
    private static final int SAMPLES = 20 * ValidatedTable.ENOUGH;
    private static final long SEED = 20140607;

    public Optional<Direction> light() {
        return visible.light();
    }

    public TileGrid grid(TableDesign design) {
        return light().map(light -> TileGrid.of(design, light)).orElseGet(() -> TileGrid.of(design, visible));
    }

    public BitSet tiles(TileGrid grid) {
        if (light().isPresent()) {
            return grid.space() instanceof TableSpace.OneLight ? grid.reachable() : grid.reachable(light().get());
        }
        BitSet tiles = new BitSet();
        TileGrid.Feedback marks = new TileGrid.Feedback(grid, tiles);
        visible.pairs().forEach(pair -> marks.mark(pair.u(), pair.v(), pair.w()));
        return tiles;
    }

    /** Returns an upper estimate of the memory of a table, and of baking it. */
    public MemoryNeed memory(TableDesign design) {
        TileGrid grid = grid(design);
        double all = (double) grid.columns() * grid.rows();
        // Each point may lie on a corner of four tiles.
        double tilesOfSlice = light().isPresent()
                ? Math.PI / 4 * all
                : Math.min(4.0 * visible.pairs().size(), all);
        long tiles = (long) (tilesOfSlice * Math.min(grid.slices(), TableDesign.TAPS + 1));
        List<ArrayLayout> arrays = List.of(AtlasPages.texels(tiles), grid.tileList(1));
        long textures = arrays.stream().mapToLong(ArrayLayout::bytes).sum();
        return new MemoryNeed(2 * textures + 2 * LevelBaking.sampleBytes(tiles), arrays);
    }

    public VisibleRange range(TableDesign design) {
        double margin = 2 * TileGrid.STORED_SIDE * design.step();
        if (light().isPresent()) {
            TableSpace space = new TableSpace.OneLight(light().get());
            double least = -space.uvw(TableSpace.OneLight.HORIZON + margin, 0, 0)[2];
            return visible.with(0, least, visible.maximumW());
        }
        // Refinement makes slices closer, so that they stay within this range.
        double slices = (TableDesign.TAPS + 1) * design.sliceStep();
        return visible.with(margin, Math.max(0, visible.minimumW() - slices), Math.min(2, visible.maximumW() + slices));
    }

    public double farthest() {
        return light().map(light -> 1 + Math.hypot(light.x(), light.y())).orElse(TableSpace.AllLights.REACH);
    }

    /** Returns directions for validation; those of one light are uniform on an orthographic map. */
    public List<DirectionPair> samples() {
        Random random = new Random(SEED);
        List<DirectionPair> samples = new ArrayList<>(visible.pairs());
        Collections.shuffle(samples, random);
        while (light().isPresent() && samples.size() < SAMPLES) {
            double x = 2 * random.nextDouble() - 1;
            double y = 2 * random.nextDouble() - 1;
            double height = 1 - x * x - y * y;
            if (height > 0) {
                samples.add(new DirectionPair(light().get(), new Direction(x, y, Math.sqrt(height))));
            }
        }
        return samples.subList(0, Math.min(samples.size(), SAMPLES));
    }

    public String key() {
        Sha256 hash = new Sha256();
        ByteBuffer bytes = ByteBuffer.allocate(3 * Double.BYTES);
        for (DirectionPair pair : visible.pairs()) {
            bytes.clear().putDouble(pair.u()).putDouble(pair.v()).putDouble(pair.w());
            hash.add(bytes.flip());
        }
        return light().map(Direction::toString).orElseGet(hash::hex);
    }
}
