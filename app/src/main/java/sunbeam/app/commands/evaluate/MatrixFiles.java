package sunbeam.app.commands.evaluate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.ResponseMatrix;

/** A response as files for other programs. */
final class MatrixFiles {
    private MatrixFiles() {}

    /** One row per wavelength: the wavelength in nm, then the response at each angle, which heads its column. */
    static AtomicFile.StreamContent csv(ResponseMatrix response) {
        ResponseGrid grid = response.grid();
        List<String> header = new ArrayList<>();
        header.add("wavelength_nm");
        for (double angle : grid.angles()) {
            header.add(String.format(Locale.ROOT, "%.6f", Math.toDegrees(angle)));
        }
        return stream -> {
            try (CsvWriter writer = new CsvWriter(stream, header)) {
                double[] cells = new double[header.size()];
                for (int row = 0; row < response.values().length; row++) {
                    cells[0] = grid.wavelengths()[row] * 1e9;
                    System.arraycopy(response.values()[row], 0, cells, 1, cells.length - 1);
                    writer.row(cells);
                }
            }
        };
    }

    /** float32, wavelengths x angles. */
    static AtomicFile.StreamContent npy(ResponseMatrix response) {
        int columns = response.grid().angles().length;
        float[] values = new float[Math.multiplyExact(response.values().length, columns)];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) response.values()[i / columns][i % columns];
        }
        return stream -> NpyWriter.write(stream, values, response.values().length, columns);
    }
}
