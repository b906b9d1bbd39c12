package sunbeam.precompute.spectrum;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntConsumer;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.setting.ValueKind;

/**
 * DFT bins of an expansion's terms T_n(h) over one patch, limited to the visible frequencies, bin / width and bin / height. Parts are
 * {@code [term][row * bandX.count() + column]}, in ascending order of bins, rows with y; phases refer to sample (0, 0), at the top left.
 */
public record FourierTable(
        HeightMap map, Expansion expansion, Band bandX, Band bandY, float[][] real, float[][] imaginary) {
    /** Transforms the terms within bands; the consumer receives the number of terms finished by each transform. */
    public static FourierTable of(
            HeightMap heights, Expansion expansion, Band bandX, Band bandY, IntConsumer progress) {
        float[][] empty = new float[expansion.terms()][];
        FourierTable table = new FourierTable(heights, expansion, bandX, bandY, empty, empty.clone());
        table.transform(heights, progress);
        return table;
    }

    /** Transforms two real terms a, b at once, z = a + i b: A(f) = (Z(f) + Z*(-f)) / 2, B(f) = (Z(f) - Z*(-f)) / 2i. */
    private void transform(HeightMap heights, IntConsumer progress) {
        boolean inPairs = expansion.kind().hasRealBasis();
        Band x = inPairs ? bandX.symmetric() : bandX;
        Band y = inPairs ? bandY.symmetric() : bandY;
        BandTransform2d transform = new BandTransform2d(map.columns(), map.rows(), x, y);
        int count;
        for (int n = 0; n < terms(); n += count) {
            int first = n;
            count = Math.min(inPairs ? 2 : 1, terms() - n);
            DoubleUnaryOperator second = count == 2 ? s -> expansion.realBasis(first + 1, s) : s -> 0;
            ComplexVector z = transform.transform(rows(
                    heights,
                    expansion.scale(),
                    s -> expansion.realBasis(first, s),
                    inPairs ? second : s -> expansion.imaginaryBasis(first, s)));
            if (inPairs) {
                for (int term = n; term < n + count; term++) {
                    separate(z, x, y, term == n, term);
                }
            } else {
                real[n] = Floats.of(z.length(), i -> z.real()[i]);
                imaginary[n] = Floats.of(z.length(), i -> z.imaginary()[i]);
            }
            progress.accept(count);
        }
    }

    private void separate(ComplexVector z, Band symmetricX, Band symmetricY, boolean first, int term) {
        float[] re = new float[bins()];
        float[] im = new float[bins()];
        int last = z.length() - 1;
        int target = 0;
        for (int jy = bandY.first(); jy <= bandY.last(); jy++) {
            for (int jx = bandX.first(); jx <= bandX.last(); jx++, target++) {
                int at = (jy - symmetricY.first()) * symmetricX.count() + jx - symmetricX.first();
                double a = z.real()[at];
                double b = z.imaginary()[at];
                double mirroredA = z.real()[last - at];
                double mirroredB = z.imaginary()[last - at];
                re[target] = (float) (0.5 * (first ? a + mirroredA : b + mirroredB));
                im[target] = (float) (0.5 * (first ? b - mirroredB : mirroredA - a));
            }
        }
        real[term] = re;
        imaginary[term] = im;
    }

    /** Returns the rows of an image: real and imaginary parts of a term, or two real terms, at the height of each sample. */
    static BandTransform2d.RowSource rows(
            HeightMap heights, HeightScale scale, DoubleUnaryOperator realPart, DoubleUnaryOperator imaginaryPart) {
        HeightMap map = heights;
        int columns = map.columns();
        if (heights.hasTooManyLevels()) {
            return (row, realRow, imaginaryRow) -> {
                for (int column = 0; column < columns; column++) {
                    double scaled = scale.scaled(map.at(column, row));
                    realRow[column] = realPart.applyAsDouble(scaled);
                    imaginaryRow[column] = imaginaryPart.applyAsDouble(scaled);
                }
            };
        }
        double[] levels = heights.levels();
        double[] realLevels = new double[levels.length];
        double[] imaginaryLevels = new double[levels.length];
        Arrays.parallelSetAll(realLevels, i -> realPart.applyAsDouble(scale.scaled(levels[i])));
        Arrays.parallelSetAll(imaginaryLevels, i -> imaginaryPart.applyAsDouble(scale.scaled(levels[i])));
        int[] index = heights.index();
        return (row, realRow, imaginaryRow) -> {
            for (int column = 0, i = row * columns; column < columns; column++, i++) {
                realRow[column] = realLevels[index[i]];
                imaginaryRow[column] = imaginaryLevels[index[i]];
            }
        };
    }

    public int terms() {
        return real.length;
    }

    public PowerSpectrum.Axis x() {
        return new PowerSpectrum.Axis(map.width(), bandX.first(), bandX.count());
    }

    public PowerSpectrum.Axis y() {
        return new PowerSpectrum.Axis(map.height(), bandY.first(), bandY.count());
    }

    public int bins() {
        return Math.multiplyExact(bandX.count(), bandY.count());
    }

    public long bytes() {
        return 2L * Float.BYTES * terms() * bins();
    }

    /**
     * Returns the real and imaginary part {@code [2 * (term - first) + part][bin]} of some terms, each times its factor
     * {@link Expansion.Kind#turn}, with phases that refer to the sample under the window's maximum.
     */
    public double[][] amplitudes(int first, int end, WindowOrigin origin) {
        double[][] alongX = bandX.phases(map.columns(), -origin.sample(map.columns()));
        // Rows run downwards, y upwards.
        double[][] alongY = bandY.phases(map.rows(), origin.sample(map.rows()));
        double[][] amplitudes = new double[2 * (end - first)][bins()];
        for (int n = first; n < end; n++) {
            Complex turn = expansion.kind().turn(n);
            for (int i = 0; i < bins(); i++) {
                int column = i % bandX.count();
                int row = i / bandX.count();
                double cosine = alongX[0][column] * alongY[0][row] - alongX[1][column] * alongY[1][row];
                double sine = alongX[0][column] * alongY[1][row] + alongX[1][column] * alongY[0][row];
                double a = real[n][i] * turn.getReal() - imaginary[n][i] * turn.getImaginary();
                double b = real[n][i] * turn.getImaginary() + imaginary[n][i] * turn.getReal();
                amplitudes[2 * (n - first)][i] = a * cosine - b * sine;
                amplitudes[2 * (n - first) + 1][i] = a * sine + b * cosine;
            }
        }
        return amplitudes;
    }

    /**
     * Writes an HDF5 file of a temporary name, which the caller renames, for other programs (docs/conventions.md): dataset {@code terms} of
     * float32, shape (terms, 2, rows, columns) with real and imaginary parts; dataset {@code coefficients} (terms, samples) if the expansion
     * has no closed form; attributes in SI units. Throws UncheckedIOException if the file cannot be written.
     */
    public void write(Path file, String name, String digest) {
        try (WritableHdfFile hdf = HdfFile.write(file)) {
            hdf.putDataset("terms", nested());
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
            hdf.putAttribute("expansion", ValueKind.name(expansion.kind()));
            hdf.putAttribute("height_centre_metres", expansion.scale().center());
            hdf.putAttribute("height_half_range_metres", expansion.scale().halfRange());
            hdf.putAttribute("first_bin_x", bandX.first());
            hdf.putAttribute("first_bin_y", bandY.first());
            hdf.putAttribute("patch_columns", map.columns());
            hdf.putAttribute("patch_rows", map.rows());
            hdf.putAttribute("pitch_x_metres", map.pitchX());
            hdf.putAttribute("pitch_y_metres", map.pitchY());
            hdf.putAttribute("patch_name", name);
            hdf.putAttribute("patch_digest_sha256", digest);
            if (expansion.kind() != Expansion.Kind.TAYLOR) {
                CoefficientTable coefficients = CoefficientTable.sampled(expansion);
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

    private float[][][][] nested() {
        int columns = bandX.count();
        int rows = bandY.count();
        float[][][][] result = new float[terms()][2][rows][columns];
        for (int n = 0; n < terms(); n++) {
            for (int row = 0; row < rows; row++) {
                System.arraycopy(real[n], row * columns, result[n][0][row], 0, columns);
                System.arraycopy(imaginary[n], row * columns, result[n][1][row], 0, columns);
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
