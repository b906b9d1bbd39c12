package sunbeam.precompute.evaluation;

import sunbeam.precompute.optics.WindowOrigin;

/**
 * The sample under the coherence window's maximum.
 *
 * @param column counted from the left
 * @param row counted from the top
 */
public record WindowPlace(int column, int row) {

    /** The place that a named origin is on a patch of that many samples. */
    public static WindowPlace of(WindowOrigin origin, int columns, int rows) {
        return new WindowPlace(origin.sample(columns), origin.sample(rows));
    }
}
