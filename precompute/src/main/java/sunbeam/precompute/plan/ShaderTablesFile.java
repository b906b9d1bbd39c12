package sunbeam.precompute.plan;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32C;
import java.util.zip.CheckedOutputStream;
import sunbeam.precompute.files.InputException;

/**
 * {@link ShaderTables} as a file with the arrays in memory layout.
 *
 * <pre>
 * 16 bytes   "SUNBEAM1", version and length of the header (int32, big-endian)
 * header     JSON: key, label, tables without arrays, shapes of the arrays
 * arrays     layer by layer, float32, little-endian
 * 8 bytes    CRC-32C of all that comes before (int64, big-endian)
 * </pre>
 *
 * <p>The checksum finds accidental damage, ten times as fast as a cryptographic digest.
 */
public final class ShaderTablesFile {
    /** Part of every key. Raise it whenever the program changes the tables that it makes for a plan. */
    public static final int VERSION = 20;

    private static final long MAGIC = 0x53554e4245414d31L;
    private static final int PREFIX = Long.BYTES + 2 * Integer.BYTES;
    private static final int BLOCK = 1 << 20;
    // Longer than any method's header.
    private static final int LONGEST_HEADER = 1 << 20;
    private static final int ALIGNMENT = 16;
    private static final String BROKEN_HEADER = "its header cannot be read";
    private static final JsonMapper JSON = JsonMapper.builder()
            .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private ShaderTablesFile() {}

    private record Header(String key, TableLabel label, ShaderTables tables, List<ArrayLayout> layouts) {}

    static byte[] header(String key, TableLabel label, ShaderTables tables) throws IOException {
        List<ArrayLayout> layouts =
                tables.arrays().stream().map(TableArray::layout).toList();
        byte[] json = JSON.writeValueAsBytes(new Header(key, label, tables.with(List.of()), layouts));
        // Blanks align the floats.
        byte[] bytes = Arrays.copyOf(json, (json.length + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
        Arrays.fill(bytes, json.length, bytes.length, (byte) ' ');
        return bytes;
    }

    /** Writes tables, layer by layer, to a new file of a temporary name, which the caller renames; the label is for lists. */
    public static void write(Path file, String key, TableLabel label, ShaderTables tables) {
        byte[] block = new byte[BLOCK];
        FloatBuffer floats =
                ByteBuffer.wrap(block).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer();
        try (CheckedOutputStream checked = new CheckedOutputStream(Files.newOutputStream(file), new CRC32C());
                DataOutputStream stream = new DataOutputStream(checked)) {
            byte[] header = header(key, label, tables);
            stream.write(ByteBuffer.allocate(PREFIX + header.length)
                    .putLong(MAGIC)
                    .putInt(VERSION)
                    .putInt(header.length)
                    .put(header)
                    .array());
            for (TableArray array : tables.arrays()) {
                for (int layer = 0; layer < array.layout().layers(); layer++) {
                    for (FloatBuffer left = array.layer(layer).duplicate(); left.hasRemaining(); ) {
                        int count = Math.min(left.remaining(), floats.capacity());
                        floats.put(0, left, left.position(), count);
                        left.position(left.position() + count);
                        stream.write(block, 0, Float.BYTES * count);
                    }
                }
            }
            stream.writeLong(checked.getChecksum().getValue());
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write " + file + ": " + e.getMessage(), e);
        }
    }

    /**
     * Reads tables and checks the whole file. Layers stay in the file, mapped to memory: it may be replaced or deleted meanwhile, but not
     * overwritten. Throws InputException for a truncated or altered file, another version or key.
     */
    public static ShaderTables read(Path file, String key) {
        return InputException.naming(file, () -> {
            try (FileChannel channel = FileChannel.open(file)) {
                return read(channel, key);
            }
        });
    }

    /** Reads the description of a file's tables alone; throws InputException if the file has no readable header. */
    public static TableLabel label(Path file) {
        return InputException.naming(file, () -> {
            try (FileChannel channel = FileChannel.open(file)) {
                return header(channel, headerBytes(channel)).label();
            }
        });
    }

    private static int headerBytes(FileChannel channel) throws IOException {
        long size = channel.size();
        InputException.refuseIf(size < PREFIX + Long.BYTES, "truncated: " + size + " bytes are no tables");
        ByteBuffer prefix = map(channel, 0, PREFIX);
        InputException.refuseIf(prefix.getLong() != MAGIC, "not tables of Sunbeam's");
        int version = prefix.getInt();
        InputException.refuseIf(
                version != VERSION, "tables of version " + version + ", this Sunbeam reads version " + VERSION);
        int headerBytes = prefix.getInt();
        long most = Math.min(LONGEST_HEADER, size - PREFIX - Long.BYTES);
        InputException.refuseIf(headerBytes <= 0 || headerBytes > most, BROKEN_HEADER);
        return headerBytes;
    }

    private static ShaderTables read(FileChannel channel, String key) throws IOException {
        int headerBytes = headerBytes(channel);
        Header header = header(channel, headerBytes);
        requireSize(channel.size(), header, headerBytes);
        InputException.refuseIf(!header.key().equals(key), "tables of another surface or plan");
        CRC32C checksum = new CRC32C();
        checksum.update(map(channel, 0, PREFIX + headerBytes));
        List<TableArray> arrays = new ArrayList<>();
        long position = (long) PREFIX + headerBytes;
        for (ArrayLayout layout : header.layouts()) {
            List<FloatBuffer> layers = new ArrayList<>();
            int bytes = Float.BYTES * layout.floatsPerLayer();
            for (int layer = 0; layer < layout.layers(); layer++, position += bytes) {
                MappedByteBuffer piece = map(channel, position, bytes);
                checksum.update(piece.duplicate());
                layers.add(piece.order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer());
            }
            arrays.add(new TableArray(layout, layer -> layers.get(layer).duplicate()));
        }
        InputException.refuseIf(
                map(channel, position, Long.BYTES).getLong() != checksum.getValue(),
                "its checksum does not fit: the file was altered or damaged");
        return header.tables().with(arrays);
    }

    private static Header header(FileChannel channel, int length) throws IOException {
        byte[] bytes = new byte[length];
        map(channel, PREFIX, length).get(bytes);
        try {
            return JSON.readValue(bytes, Header.class);
        } catch (JacksonException e) {
            throw new InputException(BROKEN_HEADER);
        }
    }

    private static MappedByteBuffer map(FileChannel channel, long position, int bytes) throws IOException {
        return channel.map(FileChannel.MapMode.READ_ONLY, position, bytes);
    }

    /** Called before memory is allocated. One layer must not overflow an int, which limits a mapping to memory. */
    private static void requireSize(long size, Header header, int headerBytes) {
        long expected = (long) PREFIX + headerBytes + Long.BYTES;
        try {
            for (ArrayLayout layout : header.layouts()) {
                long layer = Math.multiplyExact(Float.BYTES, layout.floatsPerLayer());
                expected = Math.addExact(expected, Math.multiplyExact(layer, layout.layers()));
            }
        } catch (ArithmeticException overflow) {
            throw new InputException(BROKEN_HEADER);
        }
        InputException.refuseIf(size < expected, "truncated: " + size + " bytes left of " + expected);
        InputException.refuseIf(size > expected, "too long: " + size + " bytes instead of " + expected);
    }
}
