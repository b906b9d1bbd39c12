package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Makes the pages of a level as they are asked for: coefficients of square roots of X, Y and Z, between which the
 * level interpolates. Samples are kept, since a page's prefilter sees those of its neighbors; each is evaluated once.
 * Belongs to one thread.
 */
public final class LevelBaking {
    /** Texels before a page, or around it, that its prefilter sees: of a step at their rim POLE^8 is left, 3e-5. */
    static final int MARGIN = 8;

    private static final int STORED_SIDE = LevelGrid.STORED_SIDE;
    private static final int SIDE = LevelGrid.SIDE;
    private static final int COLORS = 3;
    private static final int CHANNELS = 4;

    /** Coefficients of a page as the shader has it: {@link LevelGrid#STORED_SIDE} rows of as many texels, 4 values each. */
    public static final int PAGE_NUMBERS = STORED_SIDE * STORED_SIDE * CHANNELS;

    private final LevelGrid grid;
    private final NumberFormat numbers;
    private final int columns;
    private final Interpolation interpolation;
    // Of the square that a page's prefilter sees.
    private final int seenSide;
    // Of each page's own texels: square roots of X, Y, Z, and which of them are known.
    private final float[][] samples;
    private final BitSet[] known;

    /**
     * Nothing is made yet.
     *
     * @param grid of the level
     * @param numbers of its coefficients
     */
    public LevelBaking(LevelGrid grid, NumberFormat numbers) {
        this.grid = grid;
        this.numbers = numbers;
        this.columns = grid.columns();
        this.interpolation = grid.interpolation();
        this.seenSide = STORED_SIDE + MARGIN + interpolation.marginBehind();
        this.samples = new float[grid.pages()][];
        this.known = new BitSet[grid.pages()];
    }

    /** Bytes of the samples of pages in Java's heap. */
    public static long sampleBytes(long pages) {
        return pages * SIDE * SIDE * COLORS * Float.BYTES;
    }

    /** How many places must be evaluated for some pages. */
    public long missing(BitSet pages) {
        return needed(pages).stream()
                .mapToLong(page -> page.texels.cardinality())
                .sum();
    }

    /**
     * Makes pages.
     *
     * @param pages their numbers
     * @return {@link #PAGE_NUMBERS} of the format each, in the order of their numbers
     */
    public List<byte[]> bake(BitSet pages, ColorSource source) {
        List<TexelColumns.Needed> needed = needed(pages).stream()
                .map(some -> new TexelColumns.Needed(some.number, some.texels, samples(some.number)))
                .toList();
        source.evaluate(new TexelColumns(grid, needed));
        needed.forEach(page -> known[page.number()].or(page.texels()));
        return Arrays.stream(pages.stream().toArray())
                .parallel()
                .mapToObj(this::coefficients)
                .toList();
    }

    /** Some texels of a page. */
    private record Needed(int number, BitSet texels) {}

    private float[] samples(int page) {
        if (samples[page] == null) {
            samples[page] = new float[SIDE * SIDE * COLORS];
            known[page] = new BitSet(SIDE * SIDE);
        }
        return samples[page];
    }

    /** Of all pages whose texels some pages' prefilters see, those texels that are not known yet. */
    private List<Needed> needed(BitSet pages) {
        BitSet[] needed = new BitSet[known.length];
        pages.stream().forEach(page -> {
            int[] place = grid.place(page);
            for (int row = -1; row <= 1; row++) {
                for (int column = -1; column <= 1; column++) {
                    int neighbor = page + row * columns + column;
                    if (needed[neighbor] == null) {
                        needed[neighbor] = new BitSet(SIDE * SIDE);
                    }
                    mark(needed[neighbor], place[0] + column, place[1] + row, place);
                }
            }
        });
        List<Needed> some = new ArrayList<>();
        for (int page = 0; page < needed.length; page++) {
            if (needed[page] != null) {
                if (known[page] != null) {
                    needed[page].andNot(known[page]);
                }
                some.add(new Needed(page, needed[page]));
            }
        }
        return some;
    }

    /** Marks those texels of the page at a column and row that the prefilter of another page sees. */
    private void mark(BitSet texels, int column, int row, int[] seeing) {
        int left = Math.max(0, seenFrom(seeing[0]) - column * SIDE);
        int right = Math.min(SIDE, seenFrom(seeing[0]) + seenSide - column * SIDE);
        int top = Math.max(0, seenFrom(seeing[1]) - row * SIDE);
        int bottom = Math.min(SIDE, seenFrom(seeing[1]) + seenSide - row * SIDE);
        for (int y = top; y < bottom; y++) {
            texels.set(y * SIDE + left, y * SIDE + right);
        }
    }

    /** First texel that the prefilter of a page in a column or row sees. */
    private static int seenFrom(int page) {
        return page * SIDE - 1 - MARGIN;
    }

    /** The page of a texel. */
    private int page(int column, int row, int slice) {
        int pageRow = row / SIDE;
        return (slice * columns + pageRow) * columns + column / SIDE;
    }

    private byte[] coefficients(int page) {
        int[] place = grid.place(page);
        // Row by row, then column by column: a filter goes along one direction of all lines at once.
        float[] rows = seen(place);
        interpolation.toCoefficients(rows, seenSide, seenSide * COLORS);
        float[] turned = storedRowsTransposed(rows);
        interpolation.toCoefficients(turned, seenSide, STORED_SIDE * COLORS);
        float[] stored = new float[PAGE_NUMBERS];
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

    /** What the prefilter of a page sees: square roots of X, Y, Z, row by row. */
    private float[] seen(int[] place) {
        float[] plane = new float[seenSide * seenSide * COLORS];
        int top = seenFrom(place[1]);
        int left = seenFrom(place[0]);
        for (int row = 0; row < seenSide; row++) {
            int run;
            for (int column = 0; column < seenSide; column += run) {
                int inPage = (left + column) % SIDE;
                run = Math.min(SIDE - inPage, seenSide - column);
                float[] roots = samples[page(left + column, top + row, place[2])];
                System.arraycopy(
                        roots,
                        COLORS * ((top + row) % SIDE * SIDE + inPage),
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
