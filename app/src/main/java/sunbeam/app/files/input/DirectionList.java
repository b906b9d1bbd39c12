package sunbeam.app.files.input;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/**
 * List of pairs of directions from a CSV file, all with a wavelength or all without.
 *
 * @param table columns theta_i, phi_i, theta_r, phi_r in degrees and optionally wavelength in nm
 * @param turnDegrees rotation of the patch about the normal in degrees, counterclockwise as seen from outside
 */
public record DirectionList(CsvTable table, double turnDegrees) {
    private static final List<String> ANGLES = List.of("theta_i", "phi_i", "theta_r", "phi_r");
    private static final String WAVELENGTH = "wavelength";
    // At the horizon the radiance of a finite power is infinite.
    private static final double LARGEST_THETA = 89.999;
    /** Largest azimuth in degrees: a hundred turns, as for the light's azimuth. */
    private static final int LARGEST_PHI = 36_000;

    /**
     * Reads the directions.
     *
     * @throws InputException if the file cannot be used; the message names line, column and value
     */
    public static DirectionList read(Path file) {
        return new DirectionList(CsvTable.read(file, ANGLES, List.of(WAVELENGTH), DirectionList::complaint), 0);
    }

    /**
     * Returns the directions relative to the patch rotated further about the normal.
     *
     * @param radians rotation in radians, counterclockwise as seen from outside
     */
    public DirectionList seenByTurned(double radians) {
        return new DirectionList(table, turnDegrees + Math.toDegrees(radians));
    }

    private static Optional<String> complaint(String column, double value) {
        if (column.startsWith("theta")) {
            return within(
                    value,
                    0,
                    LARGEST_THETA,
                    "0.." + LARGEST_THETA + " degrees; on the other side of the normal phi differs by 180");
        }
        return column.startsWith("phi")
                ? within(value, -LARGEST_PHI, LARGEST_PHI, "-" + LARGEST_PHI + ".." + LARGEST_PHI + " degrees")
                : within(value, 380 - 1e-6, 780 + 1e-6, "380..780 nm");
    }

    private static Optional<String> within(double value, double least, double most, String words) {
        return value >= least && value <= most ? Optional.empty() : Optional.of("must lie in " + words);
    }

    public List<String> columns() {
        return table.columns();
    }

    public int size() {
        return table.rows().size();
    }

    public boolean spectral() {
        return table.columns().contains(WAVELENGTH);
    }

    /** Returns a row of the file: angles in degrees and, in a spectral list, the wavelength in nanometers. */
    public double[] row(int index) {
        return table.rows().get(index).clone();
    }

    public DirectionPair pair(int index) {
        double[] cells = table.rows().get(index);
        return new DirectionPair(
                Direction.ofDegrees(cells[0], cells[1] - turnDegrees),
                Direction.ofDegrees(cells[2], cells[3] - turnDegrees));
    }

    public double wavelength(int index) {
        return table.rows().get(index)[4] * 1e-9;
    }

    public List<DirectionPair> pairs() {
        return IntStream.range(0, size()).mapToObj(this::pair).toList();
    }
}
