package sunbeam.precompute.table;

/**
 * Identity of a surface in tables and cache keys; pitches in meters.
 *
 * @param name name in messages and file attributes, not unique
 * @param digest SHA-256 of grid and heights, in hexadecimal
 */
public record PatchIdentity(String name, int columns, int rows, double pitchX, double pitchY, String digest) {

    /** Returns the period along x, meters. */
    public double width() {
        return columns * pitchX;
    }

    /** Returns the period along y, meters. */
    public double height() {
        return rows * pitchY;
    }
}
