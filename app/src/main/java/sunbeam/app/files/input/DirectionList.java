package sunbeam.app.files.input;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** Directions from a CSV file, with or without a wavelength each. */
public final class DirectionList {
    private static final List<String> ANGLES = List.of("theta_i", "phi_i", "theta_r", "phi_r");
    private static final String WAVELENGTH = "wavelength";
    // At the horizon the radiance of a finite power is not finite.
    private static final double LARGEST_THETA = 89.999;
    /** A hundred turns, as with the light's azimuth; of much larger angles rounding leaves no digit. */
    private static final int LARGEST_PHI = 36_000;

    private final List<String> columns;
    private final List<double[]> rows;

    private DirectionList(List<String> columns, List<double[]> rows) {
        this.columns = columns;
        this.rows = rows;
    }

    /**
     * Reads and checks a list.
     *
     * @throws sunbeam.app.files.input.InputException when the file cannot be used, naming line, column and value
     */
    public static DirectionList read(Path file) {
        CsvTable table = CsvTable.read(file, ANGLES, List.of(WAVELENGTH));
        List<String> columns = new ArrayList<>(ANGLES);
        if (table.has(WAVELENGTH)) {
            columns.add(WAVELENGTH);
        }
        List<double[]> rows = new ArrayList<>(table.rows());
        for (int row = 0; row < table.rows(); row++) {
            double[] cells = new double[columns.size()];
            for (int c = 0; c < cells.length; c++) {
                cells[c] = table.at(row, columns.get(c));
                requireWithin(table, row, columns.get(c));
            }
            rows.add(cells);
        }
        return new DirectionList(columns, rows);
    }

    private static void requireWithin(CsvTable table, int row, String column) {
        double value = table.at(row, column);
        if (column.startsWith("theta") && !(value >= 0 && value <= LARGEST_THETA)) {
            throw table.failure(row, column, "must lie in 0.." + LARGEST_THETA + " degrees");
        }
        if (column.startsWith("phi") && !(Math.abs(value) <= LARGEST_PHI)) {
            throw table.failure(row, column, "must lie in -" + LARGEST_PHI + ".." + LARGEST_PHI + " degrees");
        }
        if (column.equals(WAVELENGTH) && !(value >= 380 - 1e-6 && value <= 780 + 1e-6)) {
            throw table.failure(row, column, "must lie in 380..780 nm");
        }
    }

    public List<String> columns() {
        return columns;
    }

    public int size() {
        return rows.size();
    }

    /** Whether every row has a wavelength. */
    public boolean spectral() {
        return columns.contains(WAVELENGTH);
    }

    /** A row as it was given: degrees, nanometres. */
    public double[] row(int index) {
        return rows.get(index).clone();
    }

    public DirectionPair pair(int index) {
        double[] cells = rows.get(index);
        return new DirectionPair(Direction.ofDegrees(cells[0], cells[1]), Direction.ofDegrees(cells[2], cells[3]));
    }

    /** Wavelength of a row in metres. */
    public double wavelength(int index) {
        return rows.get(index)[4] * 1e-9;
    }

    public List<DirectionPair> pairs() {
        return IntStream.range(0, size()).mapToObj(this::pair).toList();
    }
}
