package sunbeam.precompute.spectrum;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import sunbeam.precompute.setting.ValueKind;

/**
 * Writer of Fourier tables as HDF5, for other programs (docs/conventions.md): dataset {@code terms} of float32, shape (terms, 2, rows,
 * columns) with real and imaginary parts; dataset {@code coefficients} (terms, samples) if the expansion has no closed form; attributes in
 * SI units.
 */
public final class TableFile {
    private TableFile() {}

    /** Writes to a temporary name, which the caller renames; throws UncheckedIOException if the file cannot be written. */
    public static void write(Path file, FourierTable table, String name, String digest) {
        try (WritableHdfFile hdf = HdfFile.write(file)) {
            hdf.putDataset("terms", nested(table));
            hdf.putAttribute("format", "sunbeam fourier table");
            hdf.putAttribute("format_version", 1);
            hdf.putAttribute(
                    "content", "terms[n][0] + i terms[n][1]: inverse DFT (1/N, exp(+i)) of T_n(h) of one period");
            hdf.putAttribute(
                    "rows_are", "bins of y, ascending from first_bin_y; frequency = bin / height, cycles per metre");
            hdf.putAttribute(
                    "columns_are", "bins of x, ascending from first_bin_x; frequency = bin / width, cycles per metre");
            hdf.putAttribute(
                    "window",
                    "none: the Gaussian window acts when the table is used; phases refer to the top left sample");
            hdf.putAttribute("expansion", ValueKind.name(table.expansion().kind()));
            hdf.putAttribute("height_centre_metres", table.expansion().scale().center());
            hdf.putAttribute(
                    "height_half_range_metres", table.expansion().scale().halfRange());
            hdf.putAttribute("first_bin_x", table.bandX().first());
            hdf.putAttribute("first_bin_y", table.bandY().first());
            hdf.putAttribute("patch_columns", table.map().columns());
            hdf.putAttribute("patch_rows", table.map().rows());
            hdf.putAttribute("pitch_x_metres", table.map().pitchX());
            hdf.putAttribute("pitch_y_metres", table.map().pitchY());
            hdf.putAttribute("patch_name", name);
            hdf.putAttribute("patch_digest_sha256", digest);
            if (table.expansion().kind() != Expansion.Kind.TAYLOR) {
                CoefficientTable coefficients = CoefficientTable.sampled(table.expansion());
                float[][] values = new float[coefficients.terms()][];
                Arrays.setAll(values, coefficients::floats);
                hdf.putDataset("coefficients", values);
                hdf.putAttribute("coefficients_first_phase_radians", coefficients.minimumPhase());
                hdf.putAttribute("coefficients_last_phase_radians", coefficients.maximumPhase());
            }
        } catch (RuntimeException e) {
            throw new UncheckedIOException(
                    "cannot write " + file + ": " + rootMessage(e), new IOException(rootMessage(e), e));
        }
    }

    private static float[][][][] nested(FourierTable table) {
        int columns = table.bandX().count();
        int rows = table.bandY().count();
        float[][][][] result = new float[table.terms()][2][rows][columns];
        for (int n = 0; n < table.terms(); n++) {
            for (int row = 0; row < rows; row++) {
                System.arraycopy(table.real()[n], row * columns, result[n][0][row], 0, columns);
                System.arraycopy(table.imaginary()[n], row * columns, result[n][1][row], 0, columns);
            }
        }
        return result;
    }

    private static String rootMessage(Throwable failure) {
        Throwable cause = failure;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return cause.getMessage() == null ? cause.getClass().getSimpleName() : cause.getMessage();
    }
}
