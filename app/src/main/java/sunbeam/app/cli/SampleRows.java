package sunbeam.app.cli;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.DatasetCreationOptions;
import io.jhdf.exceptions.HdfException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.zip.Deflater;
import java.util.zip.ZipOutputStream;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.RadialBaker;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.work.Progress;

/** Random rows: a light and a view with their color, or a wavelength and its power. A row depends only on the seed and its number. */
final class SampleRows {
    private static final int CHANNELS = 3;
    // Number of first rows of a file whose colors are compared with direct sums over wavelengths.
    static final int CHECKED_ROWS = 100;
    // Values of |w|, relative to the largest possible, at which each cell is evaluated for its weight.
    private static final double[] DEPTHS = {0.95, 0.7, 0.4};
    // Least standard deviation of an order, in sides of a cell: narrower ones would be missed between cell centers.
    private static final double LEAST_WIDTH = 0.6;

    private final RadialBaker colors;
    private final PairDensity density;
    private final Progress token;
    // Colors of the batch that was checked, which begins at this row.
    private float[] checkedBatch = {};
    private long checkedFirst;

    /** @param plan plan with the ensemble average */
    SampleRows(ColorTablePlan plan, PowerSpectrum spectrum, CieTable cie, long seed, Progress token) {
        ColorTable table = plan.table();
        this.colors = new RadialBaker(spectrum, cie, table.levels().get(0));
        this.token = token;
        double least = LEAST_WIDTH * 4 / PairDensity.SIDE / ColorTable.MIDDLE_WAVELENGTH;
        ColorTable.Level blurredLevel = table.levels().stream()
                .filter(level -> level.area().window().sigmaFrequency() > least)
                .findFirst()
                .orElseThrow();
        float[] weights = weights(new RadialBaker(spectrum, cie, blurredLevel));
        this.density = new PairDensity(cell -> weights[cell], seed);
    }

    /** Returns the weight of each cell: the square root of the largest of X, Y, Z in it. Roots give weak orders more rows. */
    private static float[] weights(RadialBaker blurred) {
        int[] cells = IntStream.range(0, PairDensity.SIDE * PairDensity.SIDE)
                .filter(PairDensity::isInside)
                .toArray();
        float[] places = new float[CHANNELS * DEPTHS.length * cells.length];
        int at = 0;
        for (int cell : cells) {
            double deepest = Math.sqrt(4 - Math.pow(PairDensity.radius(cell), 2));
            for (double depth : DEPTHS) {
                places[at++] = (float) PairDensity.u(cell);
                places[at++] = (float) PairDensity.v(cell);
                places[at++] = (float) (-depth * deepest);
            }
        }
        float[] xyz = blurred.bakeRepeatably(places, Progress.NONE);
        float[] weights = new float[PairDensity.SIDE * PairDensity.SIDE];
        for (int i = 0; i < xyz.length; i++) {
            int cell = cells[i / (CHANNELS * DEPTHS.length)];
            weights[cell] = Math.max(weights[cell], (float) Math.sqrt(xyz[i]));
        }
        return weights;
    }

    /** @param wavelength meters */
    record Row(DirectionPair pair, double wavelength) {}

    Row row(long number) {
        SplittableRandom random = density.random(number);
        DirectionPair pair = density.pair(number, random);
        double share = random.nextDouble();
        return new Row(
                pair,
                CieTable.MINIMUM_WAVELENGTH + share * (CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH));
    }

    float[] xyz(long first, int count) {
        return first == checkedFirst && CHANNELS * count == checkedBatch.length
                ? checkedBatch
                : colors.bakeRepeatably(places(first, count), token);
    }

    double power(Row row) {
        return colors.power(row.pair().u(), row.pair().v(), row.pair().w(), row.wavelength());
    }

    private float[] places(long first, int count) {
        return values(first, count, CHANNELS, row ->
                new double[] {row.pair().u(), row.pair().v(), row.pair().w()});
    }

    /** Returns the errors of the first {@code checked} rows of a file against direct sums over wavelengths; keeps its first batch. */
    ErrorStatistics differenceFromSums(long first, int rows, int checked, Progress checks) {
        checkedBatch = xyz(first, Math.min(rows, RowFile.BATCH));
        checkedFirst = first;
        float[] exact = colors.direct().bake(places(first, checked), checks);
        return Comparison.relative(IntStream.range(0, checked)
                .mapToObj(i -> new Comparison(Comparison.xyz(checkedBatch, i), Comparison.xyz(exact, i), 1))
                .toList());
    }

    List<RowFile.Column> colorColumns() {
        return List.of(
                column("light", CHANNELS, row -> xyz(row.pair().wi())),
                column("view", CHANNELS, row -> xyz(row.pair().wr())),
                new RowFile.Column("xyz", CHANNELS, this::xyz),
                column("density", 1, row -> new double[] {density.at(row.pair())}));
    }

    List<RowFile.Column> spectralColumns(CoherenceWindow window) {
        double band = 1e9 * (CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH);
        return List.of(
                column("light", CHANNELS, row -> xyz(row.pair().wi())),
                column("view", CHANNELS, row -> xyz(row.pair().wr())),
                column("wavelength", 1, row -> new double[] {1e9 * row.wavelength()}),
                column("power", 1, row -> {
                    token.step(1);
                    return new double[] {power(row)};
                }),
                column("brdf", 1, row ->
                        new double[] {Gain.KERATIN.brdf(row.pair(), window, row.wavelength()) * power(row)}),
                column("density", 1, row -> new double[] {density.at(row.pair()) / band}));
    }

    private static double[] xyz(Direction direction) {
        return new double[] {direction.x(), direction.y(), direction.z()};
    }

    private RowFile.Column column(String name, int width, Function<Row, double[]> of) {
        return new RowFile.Column(name, width, (first, count) -> values(first, count, width, of));
    }

    private float[] values(long first, int count, int width, Function<Row, double[]> of) {
        float[] values = new float[width * count];
        IntStream.range(0, count).parallel().forEach(i -> {
            double[] some = of.apply(row(first + i));
            for (int c = 0; c < width; c++) {
                values[width * i + c] = (float) some[c];
            }
        });
        return values;
    }

    /** Writer of a file of samples: one float32 array per column. The metadata is JSON. */
    record RowFile(long first, int rows, List<Column> columns, String metadata) {
        static final int BATCH = 1 << 21;
        // Rows of an HDF5 chunk: 768 KB for a column of width 3.
        private static final int CHUNK_ROWS = 1 << 16;
        // Numbers per row: two directions of three; X, Y, Z or wavelength, power and BRDF; density.
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
                zip.write(metadata.getBytes(StandardCharsets.UTF_8));
                zip.closeEntry();
            }
        }

        /** Writes HDF5, stored in chunks of rows. The library takes whole arrays, so all rows are in memory. */
        void writeHdf5(Path file) throws IOException {
            try (WritableHdfFile hdf = HdfFile.write(file)) {
                for (Column column : columns) {
                    int[] chunk = column.shape(Math.min(rows, CHUNK_ROWS));
                    DatasetCreationOptions options = DatasetCreationOptions.builder()
                            .chunkDimensions(chunk)
                            .build();
                    hdf.putDataset(column.name(), whole(column), options);
                }
                hdf.putAttribute("metadata", metadata);
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
}
