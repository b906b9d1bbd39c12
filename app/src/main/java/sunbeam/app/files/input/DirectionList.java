package sunbeam.app.files.input;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/**
 * Directions from a CSV file, with or without a wavelength each.
 *
 * @param table of theta_i, phi_i, theta_r, phi_r in degrees and, where there are wavelengths, these in nm
 * @param turnDegrees of the patch about the normal, counter-clockwise seen from outside
 */
public record DirectionList(CsvTable table, double turnDegrees) {
    private static final List<String> ANGLES = List.of("theta_i", "phi_i", "theta_r", "phi_r");
    private static final String WAVELENGTH = "wavelength";
    // At the horizon the radiance of a finite power is not finite.
    private static final double LARGEST_THETA = 89.999;
    /** A hundred turns, as with the light's azimuth; of much larger angles rounding leaves no digit. */
    private static final int LARGEST_PHI = 36_000;

    /**
     * Reads and checks a list.
     *
     * @throws sunbeam.app.files.input.InputException when the file cannot be used, naming line, column and value
     */
    public static DirectionList read(Path file) {
        return new DirectionList(CsvTable.read(file, ANGLES, List.of(WAVELENGTH), DirectionList::complaint), 0);
    }

    /**
     * The same directions as a patch has them that is turned about the normal.
     *
     * @param radians counter-clockwise seen from outside
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

    /** Whether every row has a wavelength. */
    public boolean spectral() {
        return table.columns().contains(WAVELENGTH);
    }

    /** A row as it was given: degrees, nanometers. */
    public double[] row(int index) {
        return table.rows().get(index).clone();
    }

    /** The directions of a row, in the patch's frame. */
    public DirectionPair pair(int index) {
        double[] cells = table.rows().get(index);
        return new DirectionPair(
                Direction.ofDegrees(cells[0], cells[1] - turnDegrees),
                Direction.ofDegrees(cells[2], cells[3] - turnDegrees));
    }

    /** Wavelength of a row in meters. */
    public double wavelength(int index) {
        return table.rows().get(index)[4] * 1e-9;
    }

    public List<DirectionPair> pairs() {
        return IntStream.range(0, size()).mapToObj(this::pair).toList();
    }
}
