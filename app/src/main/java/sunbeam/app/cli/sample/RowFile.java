package sunbeam.app.cli.sample;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.DatasetCreationOptions;
import io.jhdf.exceptions.HdfException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import java.util.zip.Deflater;
import java.util.zip.ZipOutputStream;
import sunbeam.app.files.output.NpyWriter;

/** Writer of a file of samples: one float32 array per column. The metadata is JSON, supplied after the columns are written. */
record RowFile(long first, int rows, List<Column> columns, Supplier<String> metadata) {
    static final int BATCH = 1 << 21;

    // Rows of an HDF5 chunk: 768 KB for a column of width 3.
    private static final int CHUNK_ROWS = 1 << 16;

    /** Numbers per row: two directions of three; X, Y, Z or wavelength, power and BRDF; density. */
    private static final int NUMBERS_OF_ROW = 10;

    record Column(String name, int width, Values values) {
        int[] shape(int rows) {
            return width == 1 ? new int[] {rows} : new int[] {rows, width};
        }
    }

    @FunctionalInterface
    interface Values {
        /** Returns {@code rows * width} values, row by row. */
        float[] of(long firstRow, int rows);
    }

    static long bytes(long rows) {
        return rows * Float.BYTES * NUMBERS_OF_ROW;
    }

    void writeNpz(OutputStream stream) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(stream)) {
            // Random numbers hardly deflate.
            zip.setLevel(Deflater.NO_COMPRESSION);
            for (Column column : columns) {
                zip.putNextEntry(NpyWriter.entry(column.name() + ".npy"));
                NpyWriter.writeHeader(zip, column.shape(rows));
                for (int done = 0; done < rows; done += BATCH) {
                    NpyWriter.writeValues(zip, column.values().of(first + done, Math.min(BATCH, rows - done)));
                }
            }
            zip.putNextEntry(NpyWriter.entry("metadata.json"));
            zip.write(metadata.get().getBytes(StandardCharsets.UTF_8));
            zip.closeEntry();
        }
    }

    /** Writes HDF5, stored in chunks of rows. The library takes whole arrays, so all rows are in memory. */
    void writeHdf5(Path file) throws IOException {
        try (WritableHdfFile hdf = HdfFile.write(file)) {
            for (Column column : columns) {
                int[] chunk = column.shape(Math.min(rows, CHUNK_ROWS));
                hdf.putDataset(
                        column.name(),
                        whole(column),
                        DatasetCreationOptions.builder().chunkDimensions(chunk).build());
            }
            hdf.putAttribute("metadata", metadata.get());
        } catch (HdfException failure) {
            throw new IOException(failure.getMessage(), failure);
        }
    }

    private Object whole(Column column) {
        float[] flat = new float[column.width() == 1 ? rows : 0];
        float[][] nested = new float[column.width() == 1 ? 0 : rows][column.width()];
        for (int done = 0; done < rows; done += BATCH) {
            int count = Math.min(BATCH, rows - done);
            float[] some = column.values().of(first + done, count);
            if (column.width() == 1) {
                System.arraycopy(some, 0, flat, done, count);
            } else {
                for (int i = 0; i < count; i++) {
                    System.arraycopy(some, column.width() * i, nested[done + i], 0, column.width());
                }
            }
        }
        return column.width() == 1 ? flat : nested;
    }
}
