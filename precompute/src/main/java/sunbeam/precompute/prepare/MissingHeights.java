package sunbeam.precompute.prepare;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.HeightMap;

/**
 * Fills missing samples (NaN or infinite) from their surroundings: ring by ring from the edge of each hole inwards,
 * every sample becomes the average of those of its up to eight neighbors that are known already. Samples of one ring
 * do not see each other, so the result does not depend on the order of the scan. Linear in the number of samples.
 */
public final class MissingHeights {
    private static final byte KNOWN = 0;
    private static final byte MISSING = 1;
    private static final byte QUEUED = 2;

    private final int columns;
    private final int rows;
    private final double[] heights;
    private final byte[] state;
    private final int count;

    /**
     * Heights of which none is missing.
     *
     * @param field the heights without missing samples
     * @param count how many samples were filled
     */
    public record Filled(HeightMap field, int count) {}

    private MissingHeights(HeightMap field) {
        columns = field.columns();
        rows = field.rows();
        heights = field.heights().clone();
        state = new byte[heights.length];
        int missing = 0;
        for (int i = 0; i < heights.length; i++) {
            if (!Double.isFinite(heights[i])) {
                state[i] = MISSING;
                missing++;
            }
        }
        count = missing;
    }

    /**
     * The heights with every missing sample filled.
     *
     * @throws IllegalArgumentException when all samples are missing
     */
    public static Filled fill(HeightMap field) {
        MissingHeights filling = new MissingHeights(field);
        if (filling.count == 0) {
            return new Filled(field, 0);
        }
        if (filling.count == filling.heights.length) {
            throw new IllegalArgumentException("all " + filling.count + " samples are missing");
        }
        filling.fillRings();
        return new Filled(field.with(filling.heights), filling.count);
    }

    private void fillRings() {
        int[] ring = IntStream.range(0, state.length)
                .filter(i -> state[i] == MISSING && neighbors(i, KNOWN).length > 0)
                .toArray();
        while (ring.length > 0) {
            double[] averages =
                    Arrays.stream(ring).mapToDouble(this::averageOfKnown).toArray();
            for (int i = 0; i < ring.length; i++) {
                heights[ring[i]] = averages[i];
                state[ring[i]] = KNOWN;
            }
            // A sample that two of the ring have for a neighbor is queued once.
            ring = Arrays.stream(ring)
                    .flatMap(i -> Arrays.stream(neighbors(i, MISSING)))
                    .filter(this::queue)
                    .toArray();
        }
    }

    private boolean queue(int index) {
        boolean first = state[index] == MISSING;
        state[index] = QUEUED;
        return first;
    }

    private double averageOfKnown(int index) {
        int[] known = neighbors(index, KNOWN);
        double first = heights[known[0]];
        // Relative to one of them, so that a large common offset costs no digits.
        return first + Arrays.stream(known).mapToDouble(i -> heights[i] - first).sum() / known.length;
    }

    /** Indices of the up to eight neighbors in the given state; the patch's edge is not wrapped: scans do not tile. */
    private int[] neighbors(int index, byte wanted) {
        int row = index / columns;
        int column = index % columns;
        int[] found = new int[8];
        int length = 0;
        for (int r = Math.max(0, row - 1); r <= Math.min(rows - 1, row + 1); r++) {
            for (int c = Math.max(0, column - 1); c <= Math.min(columns - 1, column + 1); c++) {
                int neighbor = r * columns + c;
                if (neighbor != index && state[neighbor] == wanted) {
                    found[length++] = neighbor;
                }
            }
        }
        return Arrays.copyOf(found, length);
    }
}
