package sunbeam.precompute.colourtable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * Makes the pages of a level as they are asked for: coefficients of square roots of X, Y and Z, between which the
 * level interpolates. Samples are kept, since a page's prefilter sees those of its neighbours; each is evaluated once.
 * Belongs to one thread.
 */
public final class LevelBaking {
    /** Texels before a page, or around it, that its prefilter sees: of a step at their rim POLE^8 is left, 3e-5. */
    static final int MARGIN = 8;

    private static final int STORED_SIDE = LevelGrid.STORED_SIDE;
    private static final int SIDE = LevelGrid.SIDE;
    private static final int COLOURS = 3;
    private static final int CHANNELS = 4;
    // Places that are evaluated at once: 50 MB each way. Few, and sources by rays would go along the same rays again.
    private static final int BATCH = 1 << 22;

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
        return pages * SIDE * SIDE * COLOURS * Float.BYTES;
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
    public List<byte[]> bake(BitSet pages, ColourSource source) {
        List<Needed> needed = needed(pages);
        evaluate(needed, source);
        needed.forEach(page -> known[page.number].or(page.texels));
        return Arrays.stream(pages.stream().toArray())
                .parallel()
                .mapToObj(this::coefficients)
                .toList();
    }

    /** Some texels of a page. */
    private record Needed(int number, BitSet texels) {}

    /** Of all pages whose texels some pages' prefilters see, those texels that are not known yet. */
    private List<Needed> needed(BitSet pages) {
        BitSet[] needed = new BitSet[known.length];
        pages.stream().forEach(page -> {
            int[] place = grid.place(page);
            for (int row = -1; row <= 1; row++) {
                for (int column = -1; column <= 1; column++) {
                    int neighbour = page + row * columns + column;
                    if (needed[neighbour] == null) {
                        needed[neighbour] = new BitSet(SIDE * SIDE);
                    }
                    mark(needed[neighbour], place[0] + column, place[1] + row, place);
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

    private void evaluate(List<Needed> needed, ColourSource source) {
        needed.forEach(page -> {
            if (samples[page.number] == null) {
                samples[page.number] = new float[SIDE * SIDE * COLOURS];
                known[page.number] = new BitSet(SIDE * SIDE);
            }
        });
        long[] texels = inOrder(needed);
        for (int start = 0; start < texels.length; start += BATCH) {
            evaluate(Arrays.copyOfRange(texels, start, Math.min(texels.length, start + BATCH)), source);
        }
    }

    /**
     * In {@link MortonOrder}, all slices of a place together: those that read the same, or nearly so, are asked for together. A
     * page's side is a power of two, so that pages in that order have their texels in it, too.
     */
    private long[] inOrder(List<Needed> needed) {
        Map<Long, List<Needed>> byPlace = new TreeMap<>();
        for (Needed page : needed) {
            int[] place = grid.place(page.number);
            byPlace.computeIfAbsent(MortonOrder.number(place[0], place[1]), number -> new ArrayList<>())
                    .add(page);
        }
        List<Map.Entry<Long, List<Needed>>> places = List.copyOf(byPlace.entrySet());
        int[] first = new int[places.size() + 1];
        for (int i = 0; i < places.size(); i++) {
            int count = places.get(i).getValue().stream()
                    .mapToInt(page -> page.texels.cardinality())
                    .sum();
            first[i + 1] = Math.addExact(first[i], count);
        }
        long[] texels = new long[first[places.size()]];
        IntStream.range(0, places.size())
                .parallel()
                .forEach(i -> putInOrder(places.get(i).getKey(), places.get(i).getValue(), texels, first[i]));
        return texels;
    }

    private void putInOrder(long place, List<Needed> pages, long[] texels, int first) {
        int at = first;
        int perSlice = columns * columns;
        for (int inPage = 0; inPage < SIDE * SIDE; inPage++) {
            int texel = MortonOrder.y(inPage) * SIDE + MortonOrder.x(inPage);
            long number = place * SIDE * SIDE + inPage;
            for (Needed page : pages) {
                if (page.texels.get(texel)) {
                    texels[at++] = number << Short.SIZE | page.number / perSlice;
                }
            }
        }
    }

    private static int number(long texel) {
        return (int) (texel >> Short.SIZE);
    }

    private static int slice(long texel) {
        return (int) (texel & 0xffff);
    }

    private void evaluate(long[] texels, ColourSource source) {
        float[] uvw = new float[3 * texels.length];
        double origin = grid.origin();
        IntStream.range(0, texels.length).parallel().forEach(i -> {
            int number = number(texels[i]);
            grid.put(MortonOrder.x(number), MortonOrder.y(number), slice(texels[i]), origin, uvw, 3 * i);
        });
        float[] xyz = source.xyz(uvw);
        IntStream.range(0, texels.length).parallel().forEach(i -> keep(texels[i], xyz, COLOURS * i));
    }

    private void keep(long texel, float[] xyz, int from) {
        int column = MortonOrder.x(number(texel));
        int row = MortonOrder.y(number(texel));
        int page = page(column, row, slice(texel));
        int inPage = row % SIDE * SIDE + column % SIDE;
        float[] roots = samples[page];
        for (int c = 0; c < COLOURS; c++) {
            // A sum of the expansion's terms may leave a dark direction a little below nothing.
            roots[COLOURS * inPage + c] = (float) Math.sqrt(Math.max(0, xyz[from + c]));
        }
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
        interpolation.toCoefficients(rows, seenSide, seenSide * COLOURS);
        float[] turned = storedRowsTransposed(rows);
        interpolation.toCoefficients(turned, seenSide, STORED_SIDE * COLOURS);
        float[] stored = new float[PAGE_NUMBERS];
        for (int row = 0; row < STORED_SIDE; row++) {
            int to = CHANNELS * STORED_SIDE * row;
            for (int column = 0; column < STORED_SIDE; column++) {
                int from = COLOURS * ((column + MARGIN) * STORED_SIDE + row);
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
        float[] plane = new float[seenSide * seenSide * COLOURS];
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
                        COLOURS * ((top + row) % SIDE * SIDE + inPage),
                        plane,
                        COLOURS * (row * seenSide + column),
                        COLOURS * run);
            }
        }
        return plane;
    }

    /** Of the rows that are stored: column by column. */
    private float[] storedRowsTransposed(float[] plane) {
        float[] turned = new float[seenSide * STORED_SIDE * COLOURS];
        for (int row = 0; row < STORED_SIDE; row++) {
            int from = COLOURS * seenSide * (row + MARGIN);
            for (int column = 0; column < seenSide; column++) {
                int to = COLOURS * (column * STORED_SIDE + row);
                turned[to] = plane[from];
                turned[to + 1] = plane[from + 1];
                turned[to + 2] = plane[from + 2];
                from += COLOURS;
            }
        }
        return turned;
    }
}
