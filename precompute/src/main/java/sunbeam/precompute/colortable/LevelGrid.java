package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Comparator;
import java.util.stream.IntStream;
import sunbeam.precompute.shader.ArrayLayout;

/**
 * The texels of a level: a square grid over all (u, v) that two directions can have, in slices of |w|, divided into tiles.
 * Tiles are numbered row by row, slice after slice.
 *
 * @param design step and slices
 * @param interpolation between texels
 */
public record LevelGrid(TableDesign design, Interpolation interpolation) {
    /** Texels along a tile's side between which look-ups of its own fall. */
    public static final int SIDE = 16;

    /** Texels along a side of a tile as the shader has it: one before, two behind, so that a cubic B-spline stays inside. */
    public static final int STORED_SIDE = SIDE + TableTiles.BORDER;

    /** Length of (u, v) that no two directions exceed. */
    static final double REACH = 2;

    // Pixels see a little more than directions that there are. In (u, v, w).
    private static final double RIM = 0.1;
    // Of a texel and of a slice: processor and card may see a place on different sides of an edge.
    static final double ROUNDING = 0.02;

    /** Of a level. */
    public static LevelGrid of(TableLevels.Level level) {
        return new LevelGrid(level.design(), level.interpolation());
    }

    /** Tiles along u, and along v. */
    public int columns() {
        // Beside the outermost look-ups there is a tile, for what their splines reach.
        double reach = REACH / design.step() / SIDE;
        int whole = (int) reach;
        // Millions of texels ask, and Java's first compiler calls a function for what rounds up.
        return 2 * (2 + (whole < reach ? whole + 1 : whole));
    }

    /** u and v of texel (0, 0). */
    public double origin() {
        return -0.5 * columns() * SIDE * design.step();
    }

    /** u and v where the coefficient of texel (0, 0) lies. */
    public double firstCoefficient() {
        return origin() + interpolation.shift() * design.step();
    }

    /**
     * Shape of the list of tiles of some levels that begin with this one: for each that there could be its place among those that
     * there are.
     */
    public ArrayLayout tileList(int levels) {
        return ArrayLayout.layered("colorTiles", columns(), columns(), levels * design.slices(), 1);
    }

    /** Tiles of all slices. */
    public int tiles() {
        return Math.multiplyExact(Math.multiplyExact(columns(), columns()), design.slices());
    }

    /** Tiles that look-ups for two directions, and for what a little beside them, read. */
    public BitSet reachable() {
        BitSet tiles = new BitSet();
        double side = SIDE * design.step();
        for (int row = 1; row < columns() - 1; row++) {
            for (int column = 1; column < columns() - 1; column++) {
                double u = nearest(origin() + column * side, side);
                double v = nearest(origin() + row * side, side);
                double radius = Math.hypot(u, v);
                if (radius > REACH + RIM) {
                    continue;
                }
                double deepest = Math.sqrt(Math.max(0, REACH * REACH - radius * radius)) + RIM;
                int last = firstSlice(deepest / design.sliceStep() + ROUNDING) + TableDesign.TAPS - 1;
                for (int slice = 0; slice <= last; slice++) {
                    tiles.set((slice * columns() + row) * columns() + column);
                }
            }
        }
        return tiles;
    }

    /** The number nearest to 0 from one on, so far. */
    private static double nearest(double from, double length) {
        return Math.max(from, Math.min(0, from + length));
    }

    /** Tiles in an order in which those that lie side by side, as seen from the middle, follow each other. */
    public IntStream byAngle(BitSet tiles) {
        int perSlice = columns() * columns();
        return tiles.stream()
                .boxed()
                .sorted(Comparator.comparingDouble((Integer tile) -> angle(tile % perSlice))
                        .thenComparing(tile -> tile % perSlice))
                .mapToInt(Integer::intValue);
    }

    private double angle(int inSlice) {
        int row = inSlice / columns();
        return Math.atan2(row - 0.5 * columns() + 0.5, inSlice % columns() - 0.5 * columns() + 0.5);
    }

    /** Column, row and slice of a tile. */
    int[] place(int tile) {
        int perSlice = columns() * columns();
        return new int[] {tile % columns(), tile % perSlice / columns(), tile / perSlice};
    }

    /** At both ends of the range all slices lie on one side. */
    int firstSlice(double slice) {
        return Math.max(0, Math.min((int) slice - 1, design.slices() - TableDesign.TAPS));
    }

    /**
     * Puts u and v of a texel; beyond what two directions can have colors stay as they are at its edge.
     *
     * @param origin {@link #origin()}, which takes as long as the rest
     * @param uv takes them
     */
    void put(int column, int row, double origin, float[] uv) {
        double u = origin + column * design.step();
        double v = origin + row * design.step();
        double square = u * u + v * v;
        double inside = square > REACH * REACH ? REACH / Math.sqrt(square) : 1;
        uv[0] = (float) (inside * u);
        uv[1] = (float) (inside * v);
    }
}
