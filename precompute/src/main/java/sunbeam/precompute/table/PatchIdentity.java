package sunbeam.precompute.table;

/**
 * Which surface a table belongs to.
 *
 * @param name for people
 * @param columns samples along x
 * @param rows samples along y
 * @param pitchX metres
 * @param pitchY metres
 * @param digest SHA-256 of grid and heights, in hexadecimal
 */
public record PatchIdentity(String name, int columns, int rows, double pitchX, double pitchY, String digest) {

    /** Period along x, metres. */
    public double width() {
        return columns * pitchX;
    }

    /** Period along y, metres. */
    public double height() {
        return rows * pitchY;
    }
}
