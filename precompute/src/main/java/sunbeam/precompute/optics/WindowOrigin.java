package sunbeam.precompute.optics;

public enum WindowOrigin {
    /** Sample (floor(columns / 2), floor(rows / 2)), counted from the top left. */
    CENTRE,
    /** Sample (0, 0), as in the thesis: the edge between two replicas of the patch lies under the window's maximum. */
    CORNER;

    /** Returns the sample's index along an axis with a number of samples. */
    public int sample(int count) {
        return this == CENTRE ? count / 2 : 0;
    }
}
