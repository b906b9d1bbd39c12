package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Makes the tiles of a level as they are asked for: coefficients of square roots of X, Y and Z, between which the
 * level interpolates. Samples are kept, since a tile's prefilter sees those of its neighbors; each is evaluated once.
 * Belongs to one thread.
 */
public final class LevelBaking {
    /** Texels before a tile, or around it, that its prefilter sees: of a step at their rim POLE^8 is left, 3e-5. */
    static final int MARGIN = 8;

    private static final int STORED_SIDE = TileGrid.STORED_SIDE;
    private static final int SIDE = TileGrid.SIDE;
    private static final int COLORS = 3;
    private static final int CHANNELS = 4;

    /** Coefficients of a tile as the shader has it: {@link TileGrid#STORED_SIDE} rows of as many texels, 4 values each. */
    public static final int TILE_NUMBERS = STORED_SIDE * STORED_SIDE * CHANNELS;

    private final TileGrid grid;
    private final NumberFormat numbers;
    private final Interpolation interpolation;
    // Of the square that a tile's prefilter sees.
    private final int seenSide;
    // Of each tile's own texels: square roots of X, Y, Z, NaN where they are not known.
    private final Map<Integer, float[]> samples = new HashMap<>();

    /**
     * Nothing is made yet.
     *
     * @param grid of the level
     * @param numbers of its coefficients
     */
    public LevelBaking(TileGrid grid, NumberFormat numbers) {
        this.grid = grid;
        this.numbers = numbers;
        this.interpolation = grid.interpolation();
        this.seenSide = STORED_SIDE + MARGIN + interpolation.marginBehind();
    }

    /** Bytes of the samples of tiles in Java's heap. */
    public static long sampleBytes(long tiles) {
        return tiles * SIDE * SIDE * COLORS * Float.BYTES;
    }

    /** How many places must be evaluated for some tiles. */
    public long missing(BitSet tiles) {
        return needed(tiles).values().stream().mapToLong(BitSet::cardinality).sum();
    }

    /**
     * Makes tiles. What a source has evaluated before it fails is not asked of it again.
     *
     * @param tiles their numbers
     * @return {@link #TILE_NUMBERS} of the format each, in the order of their numbers
     */
    public List<byte[]> bake(BitSet tiles, ColorSource source) {
        Map<Integer, BitSet> needed = needed(tiles);
        new TexelColumns(
                        grid,
                        needed.entrySet().stream()
                                .map(entry -> new TexelColumns.Needed(
                                        entry.getKey(),
                                        entry.getValue(),
                                        samples.computeIfAbsent(entry.getKey(), number -> unknown())))
                                .toList())
                .evaluate(source);
        return Arrays.stream(tiles.stream().toArray())
                .parallel()
                .mapToObj(this::coefficients)
                .toList();
    }

    private static float[] unknown() {
        float[] roots = new float[SIDE * SIDE * COLORS];
        Arrays.fill(roots, Float.NaN);
        return roots;
    }

    /** Of all tiles whose texels some tiles' prefilters see, those texels that are not known yet. */
    private Map<Integer, BitSet> needed(BitSet tiles) {
        Map<Integer, BitSet> needed = new TreeMap<>();
        tiles.stream().forEach(tile -> {
            int[] place = grid.place(tile);
            for (int row = -1; row <= 1; row++) {
                for (int column = -1; column <= 1; column++) {
                    int neighbor = tile + row * grid.columns() + column;
                    mark(
                            needed.computeIfAbsent(neighbor, number -> new BitSet(SIDE * SIDE)),
                            place[0] + column,
                            place[1] + row,
                            place);
                }
            }
        });
        needed.forEach((tile, texels) -> {
            if (samples.containsKey(tile)) {
                clearKnown(texels, samples.get(tile));
            }
        });
        return needed;
    }

    private static void clearKnown(BitSet texels, float[] roots) {
        for (int texel = texels.nextSetBit(0); texel >= 0; texel = texels.nextSetBit(texel + 1)) {
            // Of three values the last one that is written.
            if (!Float.isNaN(roots[COLORS * texel + COLORS - 1])) {
                texels.clear(texel);
            }
        }
    }

    /** Marks those texels of the tile at a column and row that the prefilter of another tile sees. */
    private void mark(BitSet texels, int column, int row, int[] seeing) {
        int left = Math.max(0, seenFrom(seeing[0]) - column * SIDE);
        int right = Math.min(SIDE, seenFrom(seeing[0]) + seenSide - column * SIDE);
        int top = Math.max(0, seenFrom(seeing[1]) - row * SIDE);
        int bottom = Math.min(SIDE, seenFrom(seeing[1]) + seenSide - row * SIDE);
        for (int y = top; y < bottom; y++) {
            texels.set(y * SIDE + left, y * SIDE + right);
        }
    }

    /** First texel that the prefilter of a tile in a column or row sees. */
    private static int seenFrom(int tile) {
        return tile * SIDE - 1 - MARGIN;
    }

    /** The tile of a texel. */
    private int tile(int column, int row, int slice) {
        int tileRow = row / SIDE;
        return slice * grid.perSlice() + tileRow * grid.columns() + column / SIDE;
    }

    private byte[] coefficients(int tile) {
        int[] place = grid.place(tile);
        // Row by row, then column by column: a filter goes along one direction of all lines at once.
        float[] rows = seen(place);
        interpolation.toCoefficients(rows, seenSide, seenSide * COLORS);
        float[] turned = storedRowsTransposed(rows);
        interpolation.toCoefficients(turned, seenSide, STORED_SIDE * COLORS);
        float[] stored = new float[TILE_NUMBERS];
        for (int row = 0; row < STORED_SIDE; row++) {
            int to = CHANNELS * STORED_SIDE * row;
            for (int column = 0; column < STORED_SIDE; column++) {
                int from = COLORS * ((column + MARGIN) * STORED_SIDE + row);
                stored[to] = turned[from];
                stored[to + 1] = turned[from + 1];
                stored[to + 2] = turned[from + 2];
                to += CHANNELS;
            }
        }
        return numbers.encoded(stored);
    }

    /** What the prefilter of a tile sees: square roots of X, Y, Z, row by row. */
    private float[] seen(int[] place) {
        float[] plane = new float[seenSide * seenSide * COLORS];
        int top = seenFrom(place[1]);
        int left = seenFrom(place[0]);
        for (int row = 0; row < seenSide; row++) {
            int run;
            for (int column = 0; column < seenSide; column += run) {
                int inTile = (left + column) % SIDE;
                run = Math.min(SIDE - inTile, seenSide - column);
                float[] roots = samples.get(tile(left + column, top + row, place[2]));
                System.arraycopy(
                        roots,
                        COLORS * ((top + row) % SIDE * SIDE + inTile),
                        plane,
                        COLORS * (row * seenSide + column),
                        COLORS * run);
            }
        }
        return plane;
    }

    /** Of the rows that are stored: column by column. */
    private float[] storedRowsTransposed(float[] plane) {
        float[] turned = new float[seenSide * STORED_SIDE * COLORS];
        for (int row = 0; row < STORED_SIDE; row++) {
            int from = COLORS * seenSide * (row + MARGIN);
            for (int column = 0; column < seenSide; column++) {
                int to = COLORS * (column * STORED_SIDE + row);
                turned[to] = plane[from];
                turned[to + 1] = plane[from + 1];
                turned[to + 2] = plane[from + 2];
                from += COLORS;
            }
        }
        return turned;
    }
}
