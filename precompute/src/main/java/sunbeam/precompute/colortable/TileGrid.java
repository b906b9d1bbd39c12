package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Comparator;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.VisibleRange;

/**
 * Texel grid of a level, from an origin, in slices of |w|, divided into tiles, which are numbered row by row, slice after slice. Columns
 * and rows of tiles include a border of one tile on each side, which prefilters read.
 */
public record TileGrid(
        TableSpace space,
        TableDesign design,
        Interpolation interpolation,
        double originX,
        double originY,
        int columns,
        int rows) {
    /** Texels along a tile's side that the tile owns. */
    public static final int SIDE = 16;
    /** One before and two behind a tile's own texels, for cubic B-splines. */
    public static final int STORED_SIDE = SIDE + 3;
    // CPU and graphics card may round a position, in texels or slices, to different sides of an edge.
    static final double ROUNDING = 0.02;

    public static TileGrid of(ColorTable.Level level) {
        return square(new TableSpace.AllLights(), level.design(), level.interpolation(), TableSpace.AllLights.REACH);
    }

    public static TileGrid of(TableDesign design, Direction light) {
        return square(new TableSpace.OneLight(light), design, Interpolation.CUBIC, TableSpace.OneLight.HORIZON);
    }

    private static TileGrid square(TableSpace space, TableDesign design, Interpolation interpolation, double reach) {
        int columns = 2 * (2 + (int) Math.ceil(reach / design.step() / SIDE));
        double origin = -0.5 * columns * SIDE * design.step();
        return new TileGrid(space, design, interpolation, origin, origin, columns, columns);
    }

    public static TileGrid of(TableDesign design, VisibleRange range) {
        double side = SIDE * design.step();
        return new TileGrid(
                new TableSpace.AllLights(),
                design,
                Interpolation.CUBIC,
                range.minimumU() - 1.5 * side,
                range.minimumV() - 1.5 * side,
                4 + (int) ((range.maximumU() - range.minimumU()) / side),
                4 + (int) ((range.maximumV() - range.minimumV()) / side));
    }

    /** Returns x of the coefficient of texel (0, 0). */
    public double firstX() {
        return originX + interpolation.shift() * design.step();
    }

    public double firstY() {
        return originY + interpolation.shift() * design.step();
    }

    public int slices() {
        return space instanceof TableSpace.OneLight ? 1 : design.slices();
    }

    int taps() {
        return Math.min(TableDesign.TAPS, slices());
    }

    /** Returns the shape of the page table ({@link AtlasPages}) of some levels, of which this is the finest. */
    public ArrayLayout tileList(int levels) {
        return ArrayLayout.layered("colorTiles", columns, rows, levels * slices(), 2);
    }

    int perSlice() {
        return Math.multiplyExact(columns, rows);
    }

    /** Returns the tiles that all pairs of directions read, or all views under the light of a table of one light. */
    public BitSet reachable() {
        double farthest =
                space instanceof TableSpace.OneLight ? TableSpace.OneLight.HORIZON : TableSpace.AllLights.REACH;
        double reach = farthest + 2 * ROUNDING * design.step();
        return within(0, 0, reach, (nearest, unused) -> new double[] {0, Math.sqrt(reach * reach - nearest * nearest)});
    }

    /** Returns the tiles of a table of all lights that views under one light read. */
    BitSet reachable(Direction light) {
        return within(-light.x(), -light.y(), 1 + 2 * ROUNDING * design.step(), (nearest, farthest) -> new double[] {
            light.z() + Math.sqrt(Math.max(0, 1 - farthest * farthest)),
            light.z() + Math.sqrt(Math.max(0, 1 - nearest * nearest))
        });
    }

    /** The function returns the smallest and the largest |w| between two distances from the middle. */
    private BitSet within(double middleX, double middleY, double reach, BiFunction<Double, Double, double[]> depths) {
        BitSet tiles = new BitSet();
        double side = SIDE * design.step();
        for (int row = 1; row < rows - 1; row++) {
            for (int column = 1; column < columns - 1; column++) {
                double x = firstX() + column * side - middleX;
                double y = firstY() + row * side - middleY;
                double nearest = Math.hypot(nearest(x, side), nearest(y, side));
                if (nearest <= reach) {
                    double[] w = depths.apply(nearest, Math.hypot(farthest(x, side), farthest(y, side)));
                    int last = firstSlice(w[1] / design.sliceStep() + ROUNDING) + taps() - 1;
                    for (int slice = firstSlice(w[0] / design.sliceStep() - ROUNDING); slice <= last; slice++) {
                        tiles.set(slice * perSlice() + row * columns + column);
                    }
                }
            }
        }
        return tiles;
    }

    private static double nearest(double from, double length) {
        return Math.max(from, Math.min(0, from + length));
    }

    private static double farthest(double from, double length) {
        return Math.max(-from, from + length);
    }

    /** Sorts tiles by angle around the grid's center; those of one column and row are consecutive. */
    public IntStream byAngle(BitSet tiles) {
        return tiles.stream()
                .boxed()
                .sorted(Comparator.comparingDouble((Integer tile) -> angle(tile % perSlice()))
                        .thenComparing(tile -> tile % perSlice()))
                .mapToInt(Integer::intValue);
    }

    private double angle(int inSlice) {
        int row = inSlice / columns;
        return Math.atan2(row - 0.5 * rows + 0.5, inSlice % columns - 0.5 * columns + 0.5);
    }

    int[] place(int tile) {
        return new int[] {tile % columns, tile % perSlice() / columns, tile / perSlice()};
    }

    /** Returns the first slice to read; at the ends all are on one side of the position. */
    int firstSlice(double slice) {
        return Math.max(0, Math.min((int) slice - 1, slices() - taps()));
    }

    double[] uvw(int column, int row, int slice) {
        return space.uvw(originX + column * design.step(), originY + row * design.step(), slice * design.sliceStep());
    }

    /** Marks the tiles that look-ups read in a color table of all lights. Not thread-safe. */
    public static final class Feedback {
        private final TileGrid grid;
        private final BitSet tiles;
        private final double firstX;
        private final double firstY;
        private final double perStep;
        private final double perSliceStep;
        // Most look-ups of a pixel read the same tiles as the last one: skipping these is 2.5 times as fast, as
        // measured. The first and the last tile determine the others.
        private int firstTile = -1;
        private int lastTile = -1;

        public Feedback(TileGrid grid, BitSet tiles) {
            this.grid = grid;
            this.tiles = tiles;
            // Derived once, for speed: pictures mark some ten million look-ups.
            this.perStep = 1 / grid.design().step();
            this.firstX = grid.firstX() * perStep;
            this.firstY = grid.firstY() * perStep;
            this.perSliceStep = 1 / grid.design().sliceStep();
        }

        /** Also marks the neighbors within rounding of an edge. */
        public void mark(double u, double v, double w) {
            double x = u * perStep - firstX;
            double y = v * perStep - firstY;
            double slicePosition = -w * perSliceStep;
            int left = tile(x - ROUNDING, grid.columns);
            int right = tile(x + ROUNDING, grid.columns);
            int top = tile(y - ROUNDING, grid.rows);
            int bottom = tile(y + ROUNDING, grid.rows);
            int firstSlice = grid.firstSlice(slicePosition - ROUNDING);
            int lastSlice = grid.firstSlice(slicePosition + ROUNDING) + TableDesign.TAPS - 1;
            int first = number(left, top, firstSlice);
            int last = number(right, bottom, lastSlice);
            if (first == firstTile && last == lastTile) {
                return;
            }
            firstTile = first;
            lastTile = last;
            for (int row = top; row <= bottom; row++) {
                for (int column = left; column <= right; column++) {
                    for (int slice = firstSlice; slice <= lastSlice; slice++) {
                        tiles.set(number(column, row, slice));
                    }
                }
            }
        }

        private int number(int column, int row, int slice) {
            return (slice * grid.rows + row) * grid.columns + column;
        }

        /** Clamps to the tiles inside the grid's border, as in the shader, since wide footprints may exceed them. */
        private static int tile(double texel, int count) {
            // Casts are floors, since negative values are clamped.
            return Math.max(1, Math.min(count - 2, (int) (texel / SIDE)));
        }
    }
}
