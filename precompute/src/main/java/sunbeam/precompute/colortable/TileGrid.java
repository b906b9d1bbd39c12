package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.ArrayLayout;

/**
 * The texels of a level: a grid in slices of |w|, divided into tiles. Tiles are numbered row by row, slice after slice.
 *
 * @param space what the grid lies over
 * @param design step and slices
 * @param interpolation between texels
 * @param originX x of texel (0, 0)
 * @param originY y of it
 * @param columns tiles along x: those with look-ups of their own, and one around them that their prefilters see
 * @param rows tiles along y
 */
public record TileGrid(
        TableSpace space,
        TableDesign design,
        Interpolation interpolation,
        double originX,
        double originY,
        int columns,
        int rows) {
    /** Texels along a tile's side between which look-ups of its own fall. */
    public static final int SIDE = 16;

    /** Texels along a side of a tile as the shader has it: one before, two behind, so that a cubic B-spline stays inside. */
    public static final int STORED_SIDE = SIDE + 3;

    // Of a texel and of a slice: processor and card may see a place on different sides of an edge.
    static final double ROUNDING = 0.02;

    /** Of a level: all (u, v) that two directions can have. */
    public static TileGrid of(ColorTable.Level level) {
        return square(new TableSpace.AllLights(), level.design(), level.interpolation(), TableSpace.AllLights.REACH);
    }

    /** What a light shows, for points. */
    public static TileGrid of(TableDesign design, Direction light) {
        return square(new TableSpace.OneLight(light), design, Interpolation.CUBIC, TableSpace.OneLight.HORIZON);
    }

    private static TileGrid square(TableSpace space, TableDesign design, Interpolation interpolation, double reach) {
        int columns = 2 * (2 + (int) Math.ceil(reach / design.step() / SIDE));
        double origin = -0.5 * columns * SIDE * design.step();
        return new TileGrid(space, design, interpolation, origin, origin, columns, columns);
    }

    /** The (u, v) of some pairs of directions, for points. */
    public static TileGrid of(TableDesign design, List<DirectionPair> pairs) {
        VisibleRange range = VisibleRange.of(pairs);
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

    /** x where the coefficient of texel (0, 0) lies. */
    public double firstX() {
        return originX + interpolation.shift() * design.step();
    }

    /** y where the coefficient of texel (0, 0) lies. */
    public double firstY() {
        return originY + interpolation.shift() * design.step();
    }

    /** Slices of w. */
    public int slices() {
        return space.slices(design);
    }

    /** Slices that are interpolated between. */
    int taps() {
        return Math.min(TableDesign.TAPS, slices());
    }

    /**
     * Shape of the list of tiles of some levels that begin with this one: for each that there could be its cell among those that
     * there are, and that of the same tile of the next slice.
     */
    public ArrayLayout tileList(int levels) {
        return ArrayLayout.layered("colorTiles", columns, rows, levels * slices(), 2);
    }

    /** Tiles of a slice. */
    int perSlice() {
        return Math.multiplyExact(columns, rows);
    }

    /** Tiles that look-ups for two directions, or views under the one light, read. */
    public BitSet reachable() {
        double rounding = 2 * ROUNDING * design.step();
        if (space instanceof TableSpace.OneLight) {
            return within(0, 0, TableSpace.OneLight.HORIZON + rounding, (nearest, farthest) -> new double[2]);
        }
        double reach = TableSpace.AllLights.REACH + rounding;
        return within(0, 0, reach, (nearest, farthest) ->
                new double[] {0, Math.sqrt(reach * reach - nearest * nearest)});
    }

    /** Tiles of a table of all lights that views under one of them read. */
    BitSet reachable(Direction light) {
        return within(-light.x(), -light.y(), 1 + 2 * ROUNDING * design.step(), (nearest, farthest) -> new double[] {
            light.z() + Math.sqrt(Math.max(0, 1 - farthest * farthest)),
            light.z() + Math.sqrt(Math.max(0, 1 - nearest * nearest))
        });
    }

    /** The lowest and the highest |w| between two distances from the middle of what is seen. */
    private interface Depths {
        double[] between(double nearest, double farthest);
    }

    private BitSet within(double middleX, double middleY, double reach, Depths depths) {
        BitSet tiles = new BitSet();
        double side = SIDE * design.step();
        for (int row = 1; row < rows - 1; row++) {
            for (int column = 1; column < columns - 1; column++) {
                double x = firstX() + column * side - middleX;
                double y = firstY() + row * side - middleY;
                double nearest = Math.hypot(nearest(x, side), nearest(y, side));
                if (nearest <= reach) {
                    double[] w = depths.between(nearest, Math.hypot(farthest(x, side), farthest(y, side)));
                    int last = firstSlice(w[1] / design.sliceStep() + ROUNDING) + taps() - 1;
                    for (int slice = firstSlice(w[0] / design.sliceStep() - ROUNDING); slice <= last; slice++) {
                        tiles.set(slice * perSlice() + row * columns + column);
                    }
                }
            }
        }
        return tiles;
    }

    /** The number nearest to 0 from one on, so far. */
    private static double nearest(double from, double length) {
        return Math.max(from, Math.min(0, from + length));
    }

    /** The number farthest from 0. */
    private static double farthest(double from, double length) {
        return Math.max(-from, from + length);
    }

    /** Tiles in an order in which those that lie side by side, as seen from the middle, follow each other. */
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

    /** Column, row and slice of a tile. */
    int[] place(int tile) {
        return new int[] {tile % columns, tile % perSlice() / columns, tile / perSlice()};
    }

    /** At both ends of the range all slices lie on one side. */
    int firstSlice(double slice) {
        return Math.max(0, Math.min((int) slice - 1, slices() - taps()));
    }

    /** u, v and w of a texel of a slice. */
    double[] uvw(int column, int row, int slice) {
        return space.uvw(originX + column * design.step(), originY + row * design.step(), slice * design.sliceStep());
    }
}
