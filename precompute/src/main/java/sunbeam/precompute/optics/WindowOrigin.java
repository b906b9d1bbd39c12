package sunbeam.precompute.optics;

/** The sample under the coherence window's maximum. */
public enum WindowOrigin {
    /** Sample (floor(columns / 2), floor(rows / 2)), counted from the top left. */
    CENTRE,
    /** Sample (0, 0), as in the thesis: the seam of a measured patch lies under the window's maximum. */
    CORNER;

    /** Index of the sample along an axis of the given length. */
    public int sample(int count) {
        return this == CENTRE ? count / 2 : 0;
    }
}
