package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import sunbeam.precompute.work.Progress;

/**
 * Bakes the tiles of a level: filter coefficients of square roots of X, Y and Z. Stores the samples, since a tile's prefilter also reads
 * samples of neighboring tiles. Not thread-safe.
 */
public final class LevelBaking {
    /** Texels before a stored tile, and behind it if splines filter, that its prefilter reads; a spline's pole is -0.268, and 0.268^8 = 3e-5. */
    static final int MARGIN = 8;

    private static final int STORED_SIDE = TileGrid.STORED_SIDE;
    private static final int SIDE = TileGrid.SIDE;
    private static final int COLORS = 3;
    private static final int CHANNELS = 4;
    public static final int TILE_NUMBERS = STORED_SIDE * STORED_SIDE * CHANNELS;

    private final TileGrid grid;
    private final NumberFormat numbers;
    private final int largestBatch;
    // Side of the square that a tile's prefilter reads, in texels.
    private final int inputSide;
    // The key is a tile's number.
    private final Map<Integer, Samples> samples = new HashMap<>();

    /** Square roots of X, Y, Z of the texels that a tile owns, and those texels that are evaluated. */
    private record Samples(float[] roots, BitSet known) {}

    public LevelBaking(TileGrid grid, NumberFormat numbers) {
        this(grid, numbers, ColorBaker.LARGEST_BATCH);
    }

    LevelBaking(TileGrid grid, NumberFormat numbers, int largestBatch) {
        this.grid = grid;
        this.largestBatch = largestBatch;
        this.numbers = numbers;
        this.inputSide = STORED_SIDE + MARGIN + (grid.interpolation() == Interpolation.SHIFTED_LINES ? 0 : MARGIN);
    }

    public static long sampleBytes(long tiles) {
        return tiles * SIDE * SIDE * COLORS * Float.BYTES;
    }

    public long missing(BitSet tiles) {
        return missingTexels(tiles).values().stream()
                .mapToLong(BitSet::cardinality)
                .sum();
    }

    /** Returns {@link #TILE_NUMBERS} encoded numbers per tile, in ascending order; does not evaluate samples again after a failure. */
    public List<byte[]> bake(BitSet tiles, ColorBaker baker, Progress token) {
        Map<Integer, BitSet> missingTexels = missingTexels(tiles);
        missingTexels.values().removeIf(BitSet::isEmpty);
        // Sorted by angle, so that a batch is a wedge: few of the rays along which bakers compute cross two batches.
        BitSet missing = new BitSet();
        missingTexels.keySet().forEach(missing::set);
        int[] byAngle = grid.byAngle(missing).toArray();
        int end = 0;
        for (int first = 0; first < byAngle.length; first = end) {
            long count = 0;
            for (; end < byAngle.length; end++) {
                count += missingTexels.get(byAngle[end]).cardinality();
                if (end > first && count > largestBatch) {
                    break;
                }
            }
            bake(Arrays.copyOfRange(byAngle, first, end), missingTexels, baker, token);
        }
        return Arrays.stream(tiles.stream().toArray())
                .parallel()
                .mapToObj(this::coefficients)
                .toList();
    }

    /**
     * Orders the samples of all slices at one (u, v) together, and a tile's (u, v) in Morton order: successive ones read like frequencies.
     */
    private void bake(int[] tiles, Map<Integer, BitSet> missingTexels, ColorBaker baker, Progress token) {
        BitSet[] missing = Arrays.stream(tiles).mapToObj(missingTexels::get).toArray(BitSet[]::new);
        int count = Arrays.stream(missing).mapToInt(BitSet::cardinality).sum();
        int[] tileOf = new int[count];
        int[] texelOf = new int[count];
        int sample = 0;
        int end = 0;
        for (int first = 0; first < tiles.length; first = end) {
            while (end < tiles.length && tiles[end] % grid.perSlice() == tiles[first] % grid.perSlice()) {
                end++;
            }
            for (int i = 0; i < SIDE * SIDE; i++) {
                int texel = mortonX(i >>> 1) * SIDE + mortonX(i);
                for (int tile = first; tile < end; tile++) {
                    if (missing[tile].get(texel)) {
                        tileOf[sample] = tiles[tile];
                        texelOf[sample++] = texel;
                    }
                }
            }
        }
        float[] uvw = new float[COLORS * count];
        IntStream.range(0, count).parallel().forEach(i -> {
            int[] place = grid.place(tileOf[i]);
            int texel = texelOf[i];
            double[] at = grid.uvw(place[0] * SIDE + texel % SIDE, place[1] * SIDE + texel / SIDE, place[2]);
            for (int axis = 0; axis < COLORS; axis++) {
                uvw[COLORS * i + axis] = (float) at[axis];
            }
        });
        float[] xyz = baker.bake(uvw, token);
        for (int tile = 0; tile < tiles.length; tile++) {
            samples.computeIfAbsent(tiles[tile], number -> new Samples(new float[SIDE * SIDE * COLORS], new BitSet()))
                    .known
                    .or(missing[tile]);
        }
        IntStream.range(0, count).parallel().forEach(i -> {
            float[] roots = samples.get(tileOf[i]).roots;
            for (int c = 0; c < COLORS; c++) {
                // The truncated sum of terms may be slightly negative in dark directions.
                roots[COLORS * texelOf[i] + c] = (float) Math.sqrt(Math.max(0, xyz[COLORS * i + c]));
            }
        });
    }

    private Map<Integer, BitSet> missingTexels(BitSet tiles) {
        Map<Integer, BitSet> missingTexels = new HashMap<>();
        tiles.stream()
                .forEach(reader -> forEachRun(
                        reader,
                        (tile, texel, length, input) -> missingTexels
                                .computeIfAbsent(tile, number -> new BitSet(SIDE * SIDE))
                                .set(texel, texel + length)));
        missingTexels.forEach((tile, texels) -> {
            if (samples.containsKey(tile)) {
                texels.andNot(samples.get(tile).known);
            }
        });
        return missingTexels;
    }

    /** Texels of one row of a tile, which another tile's prefilter reads to its texels from {@code input} on. */
    private interface RunVisitor {
        void visit(int tile, int texel, int length, int input);
    }

    private void forEachRun(int reader, RunVisitor visitor) {
        int[] place = grid.place(reader);
        int left = place[0] * SIDE - 1 - MARGIN;
        int top = place[1] * SIDE - 1 - MARGIN;
        for (int row = 0; row < inputSide; row++) {
            int length;
            for (int column = 0; column < inputSide; column += length) {
                int inTile = (left + column) % SIDE;
                length = Math.min(SIDE - inTile, inputSide - column);
                int tile = place[2] * grid.perSlice() + (top + row) / SIDE * grid.columns() + (left + column) / SIDE;
                visitor.visit(tile, (top + row) % SIDE * SIDE + inTile, length, row * inputSide + column);
            }
        }
    }

    private byte[] coefficients(int tile) {
        float[] rows = new float[inputSide * inputSide * COLORS];
        forEachRun(
                tile,
                (from, texel, length, input) -> System.arraycopy(
                        samples.get(from).roots, COLORS * texel, rows, COLORS * input, COLORS * length));
        // The filter runs along all lines at once.
        grid.interpolation().toCoefficients(rows, inputSide, inputSide * COLORS);
        float[] transposed = new float[inputSide * STORED_SIDE * COLORS];
        for (int row = 0; row < STORED_SIDE; row++) {
            for (int column = 0; column < inputSide; column++) {
                int from = inputSide * (row + MARGIN) + column;
                System.arraycopy(rows, COLORS * from, transposed, COLORS * (column * STORED_SIDE + row), COLORS);
            }
        }
        grid.interpolation().toCoefficients(transposed, inputSide, STORED_SIDE * COLORS);
        float[] stored = new float[TILE_NUMBERS];
        for (int texel = 0; texel < STORED_SIDE * STORED_SIDE; texel++) {
            int from = (texel % STORED_SIDE + MARGIN) * STORED_SIDE + texel / STORED_SIDE;
            System.arraycopy(transposed, COLORS * from, stored, CHANNELS * texel, COLORS);
        }
        return numbers.encoded(stored);
    }

    /** Returns x of a cell by its number in Morton order (G. M. Morton, 1966), which interleaves the bits; y is x of half of it. */
    public static int mortonX(int number) {
        int x = number & 0x55555555;
        x = (x | (x >>> 1)) & 0x33333333;
        x = (x | (x >>> 2)) & 0x0f0f0f0f;
        x = (x | (x >>> 4)) & 0x00ff00ff;
        return (x | (x >>> 8)) & 0xffff;
    }
}
