package sunbeam.precompute.table;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.Dataset;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiFunction;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.text.Quoted;

/**
 * Fourier tables as HDF5: dataset {@code terms} of float32, shape (terms, 2, rows, columns) with real and imaginary
 * parts, dataset {@code coefficients} (terms, samples) where the expansion has no closed form, and attributes that say
 * what all of it means. A SHA-256 checksum covers data and attributes.
 */
public final class TableFile {
    private static final String TERMS = "terms";
    private static final String COEFFICIENTS = "coefficients";

    private TableFile() {}

    /**
     * Writes a table to a new file; the caller sees to it that nobody reads it half-written.
     *
     * @throws UncheckedIOException when the file cannot be written
     */
    public static void write(Path file, FourierTable table) {
        TableAttributes attributes = TableAttributes.describing(table);
        try (WritableHdfFile hdf = HdfFile.write(file)) {
            hdf.putDataset(TERMS, nested(table));
            table.coefficients().ifPresent(coefficients -> hdf.putDataset(COEFFICIENTS, coefficients.values()));
            attributes.values().forEach(hdf::putAttribute);
            hdf.putAttribute(TableAttributes.CHECKSUM, checksum(attributes, table));
        } catch (RuntimeException e) {
            throw new UncheckedIOException(
                    "cannot write " + file + ": " + rootMessage(e), new IOException(rootMessage(e), e));
        }
    }

    /**
     * Reads a table and checks it.
     *
     * @throws TableException when the file is missing, truncated, altered or of another version
     */
    public static FourierTable read(Path file) {
        return opened(file, TableFile::read);
    }

    /**
     * What a file says of its table. Nothing else of it is read or checked.
     *
     * @throws TableException as {@link #read}
     */
    public static TableLabel label(Path file) {
        return opened(file, (hdf, bytes) -> {
            TableAttributes attributes = attributes(hdf, bytes);
            int terms = dataset(hdf, TERMS, 4, bytes).getDimensions()[0];
            return TableLabel.of(
                    attributes.text("patch_name"),
                    attributes.text("patch_digest_sha256"),
                    String.format(
                            Locale.ROOT,
                            "Fourier table, %d %s terms",
                            terms,
                            attributes.kind().label()));
        });
    }

    private static <T> T opened(Path file, BiFunction<HdfFile, Long, T> reader) {
        if (!Files.isRegularFile(file)) {
            throw new TableException(file + ": no such table; make it with 'sunbeam precompute'");
        }
        try (HdfFile hdf = new HdfFile(file)) {
            long bytes = Files.size(file);
            if (bytes < endOfFileAddress(hdf)) {
                throw new TableException("truncated: " + bytes + " bytes left of " + endOfFileAddress(hdf));
            }
            return reader.apply(hdf, bytes);
        } catch (TableException e) {
            throw unusable(file, e.getMessage(), e);
        } catch (IOException | RuntimeException e) {
            // The HDF5 library reports damage by exceptions of many kinds; each means the same to the user.
            throw unusable(file, "not a readable HDF5 file: " + rootMessage(e), e);
        } catch (OutOfMemoryError | StackOverflowError e) {
            throw ofDamage(file, e);
        }
    }

    /**
     * A file that claims more than it holds makes the library take memory without end. A whole one needs a few times its own
     * length: where there was that much, it was damage.
     */
    private static TableException ofDamage(Path file, VirtualMachineError e) {
        if (e instanceof OutOfMemoryError
                && file.toFile().length() > Runtime.getRuntime().maxMemory() / 8) {
            throw e;
        }
        return unusable(file, "it claims more than it holds: the file was damaged", new IOException(e));
    }

    /** How long the file says it is: bytes 28 to 35 of a superblock of version 2 or 3 (HDF5 specification, II.A). */
    private static long endOfFileAddress(HdfFile hdf) {
        return hdf.getHdfBackingStorage()
                .map(28, Long.BYTES)
                .order(ByteOrder.LITTLE_ENDIAN)
                .getLong();
    }

    private static TableException unusable(Path file, String reason, Exception cause) {
        return new TableException(file + ": " + reason, "make it again with 'sunbeam precompute'", cause);
    }

    private static TableAttributes attributes(HdfFile hdf, long fileBytes) {
        Map<String, Object> values = new TreeMap<>();
        hdf.getAttributes().forEach((name, attribute) -> {
            if (attribute.getSizeInBytes() > fileBytes) {
                throw new TableException("attribute '" + Quoted.oneLine(name) + "' is larger than the file");
            }
            values.put(name, attribute.getData());
        });
        TableAttributes attributes = TableAttributes.of(values);
        if (!TableAttributes.FORMAT.equals(values.get("format"))) {
            throw new TableException("not a Sunbeam table");
        }
        int version = attributes.integer("format_version");
        if (version != TableAttributes.VERSION) {
            throw new TableException(
                    "table of version " + version + ", this Sunbeam reads version " + TableAttributes.VERSION);
        }
        return attributes;
    }

    private static FourierTable read(HdfFile hdf, long fileBytes) {
        TableAttributes attributes = attributes(hdf, fileBytes);
        Dataset terms = dataset(hdf, TERMS, 4, fileBytes);
        int[] shape = terms.getDimensions();
        if (shape[1] != 2) {
            throw new TableException("dataset '" + TERMS + "' has " + shape[1] + " parts instead of 2");
        }
        int size = Math.multiplyExact(shape[2], shape[3]);
        float[][][] parts = split(terms, shape[0], size);
        FourierTable table = new FourierTable(
                attributes.patch(),
                attributes.kind(),
                attributes.scale(),
                new Band(attributes.integer("first_bin_x"), shape[3]),
                new Band(attributes.integer("first_bin_y"), shape[2]),
                parts[0],
                parts[1],
                coefficients(hdf, attributes, fileBytes));
        if (!checksum(attributes, table).equals(attributes.text(TableAttributes.CHECKSUM))) {
            throw new TableException("its checksum does not fit: the file was altered or damaged");
        }
        return table;
    }

    private static Dataset dataset(HdfFile hdf, String name, int dimensions, long fileBytes) {
        if (!(hdf.getChild(name) instanceof Dataset dataset)) {
            throw new TableException("dataset '" + name + "' is missing");
        }
        long bytes = 4;
        for (long side : dataset.getDimensionsAsLong()) {
            if (side < 1) {
                throw new TableException("dataset '" + name + "' has an empty side");
            }
            bytes = Math.multiplyExact(bytes, side);
        }
        // Before memory is taken: a file cannot hold more numbers than it has bytes for.
        if (dataset.getDimensions().length != dimensions || dataset.getJavaType() != float.class || bytes > fileBytes) {
            throw new TableException("dataset '" + name + "' has the wrong shape or type for this file");
        }
        return dataset;
    }

    private static float[][][] split(Dataset terms, int count, int size) {
        float[] flat = (float[]) terms.getDataFlat();
        float[][][] parts = new float[2][count][size];
        for (int n = 0; n < count; n++) {
            System.arraycopy(flat, 2 * n * size, parts[0][n], 0, size);
            System.arraycopy(flat, (2 * n + 1) * size, parts[1][n], 0, size);
        }
        return parts;
    }

    private static Optional<CoefficientTable> coefficients(HdfFile hdf, TableAttributes attributes, long fileBytes) {
        if (!attributes.has("coefficients_first_phase_radians")) {
            return Optional.empty();
        }
        float[][] values = (float[][]) dataset(hdf, COEFFICIENTS, 2, fileBytes).getData();
        return Optional.of(new CoefficientTable(
                attributes.real("coefficients_first_phase_radians"),
                attributes.real("coefficients_last_phase_radians"),
                values));
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

    private static String checksum(TableAttributes attributes, FourierTable table) {
        Sha256 checksum = new Sha256().add(attributes.canonical());
        for (int n = 0; n < table.terms(); n++) {
            checksum.add(table.real()[n]).add(table.imaginary()[n]);
        }
        table.coefficients().ifPresent(coefficients -> {
            for (float[] row : coefficients.values()) {
                checksum.add(row);
            }
        });
        return checksum.hex();
    }

    private static String rootMessage(Throwable failure) {
        Throwable cause = failure;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return cause.getMessage() == null ? cause.getClass().getSimpleName() : cause.getMessage();
    }
}
