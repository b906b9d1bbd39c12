package sunbeam.precompute.evaluation;

/**
 * Diffracted power over wavelengths and directions; 1 for a flat mirror in specular direction.
 *
 * @param grid where it was evaluated
 * @param power {@code [wavelength][angle]}
 */
public record ResponseMatrix(ResponseGrid grid, double[][] power) {
    public ResponseMatrix {
        if (power.length != grid.wavelengths().length) {
            throw new IllegalArgumentException(
                    power.length + " rows for " + grid.wavelengths().length + " wavelengths");
        }
        for (double[] row : power) {
            if (row.length != grid.angles().length) {
                throw new IllegalArgumentException(row.length + " columns for " + grid.angles().length + " angles");
            }
        }
    }
}
