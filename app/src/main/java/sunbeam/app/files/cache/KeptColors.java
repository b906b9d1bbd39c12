package sunbeam.app.files.cache;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.zip.CRC32;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.table.TableLabel;

/**
 * Colors of a table that is being made, kept as they come, so that a run after one that was stopped does not evaluate them
 * again. Whoever makes the table asks for the same places in the same order. After the label, the file has a record for each
 * batch: number of places, checksum, X, Y, Z of each as float32, big endian. The checksum is of the table's key, the batch's
 * number, its places and its colors: a record that was cut off, is damaged or of something else ends what is used.
 */
final class KeptColors implements ColorSource {
    /** What a GPU draws at once (sunbeam.app.gpu.colors.GpuColors); a batch takes about a tenth of a second on llvmpipe. */
    static final int BATCH = 1 << 14;

    private static final String FORMAT = "Sunbeam colors 1";
    private static final int HEAD_BYTES = Integer.BYTES + Long.BYTES;

    private final Path file;
    private final String key;
    private final Supplier<ColorSource> making;
    private Optional<ColorSource> source = Optional.empty();
    private Optional<FileChannel> channel = Optional.empty();
    private boolean atEnd;
    private int batch;

    private KeptColors(Path file, String key, Supplier<ColorSource> making) {
        this.file = file;
        this.key = key;
        this.making = making;
    }

    /**
     * Goes on with a file, or begins one. A file that cannot be written is not: then nothing is kept.
     *
     * @param key all that determines the colors and their order
     * @param making opened when a color is missing, closed with this
     */
    static KeptColors of(Path file, String key, TableLabel label, Supplier<ColorSource> making) {
        KeptColors colors = new KeptColors(file, key, making);
        colors.open(label);
        return colors;
    }

    private void open(TableLabel label) {
        try {
            byte[] head = head(label);
            FileChannel opened = FileChannel.open(
                    file,
                    StandardOpenOption.CREATE,
                    StandardOpenOption.READ,
                    StandardOpenOption.WRITE,
                    // A link's target is somebody's file.
                    LinkOption.NOFOLLOW_LINKS);
            channel = Optional.of(opened);
            ByteBuffer found = ByteBuffer.allocate(head.length);
            boolean whole = true;
            while (found.hasRemaining() && whole) {
                whole = opened.read(found) >= 0;
            }
            atEnd = !Arrays.equals(found.array(), head);
            if (atEnd) {
                opened.truncate(0).position(0);
                write(opened, ByteBuffer.wrap(head));
            }
        } catch (IOException failure) {
            keepNoMore();
        }
    }

    private static byte[] head(TableLabel label) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeUTF(FORMAT);
        out.writeUTF(label.patch());
        out.writeUTF(label.what());
        return bytes.toByteArray();
    }

    private static void write(FileChannel channel, ByteBuffer bytes) throws IOException {
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    /** As {@link CacheEntry#label}. */
    static TableLabel labelOf(Path file) {
        return CacheEntry.labelOf(file, FORMAT);
    }

    @Override
    public float[] xyz(float[] places) {
        float[] xyz = new float[places.length];
        for (int start = 0; start < places.length; start += 3 * BATCH) {
            float[] some = Arrays.copyOfRange(places, start, Math.min(places.length, start + 3 * BATCH));
            System.arraycopy(batch(some), 0, xyz, start, some.length);
            batch++;
        }
        return xyz;
    }

    private float[] batch(float[] places) {
        Optional<float[]> kept = kept(places);
        if (kept.isPresent()) {
            return kept.get();
        }
        if (source.isEmpty()) {
            source = Optional.of(making.get());
        }
        float[] xyz = source.get().xyz(places);
        keep(places, xyz);
        return xyz;
    }

    /** The next record of the file, if it is this batch's. */
    private Optional<float[]> kept(float[] places) {
        if (channel.isEmpty() || atEnd) {
            return Optional.empty();
        }
        try {
            long start = channel.get().position();
            ByteBuffer record = ByteBuffer.allocate(HEAD_BYTES + Float.BYTES * places.length);
            boolean whole = true;
            while (record.hasRemaining() && whole) {
                whole = channel.get().read(record) >= 0;
            }
            if (whole && record.flip().getInt() == places.length / 3) {
                long checksum = record.getLong();
                float[] xyz = new float[places.length];
                record.asFloatBuffer().get(xyz);
                if (checksum == checksum(places, xyz)) {
                    return Optional.of(xyz);
                }
            }
            atEnd = true;
            channel.get().truncate(start).position(start);
        } catch (IOException failure) {
            keepNoMore();
        }
        return Optional.empty();
    }

    private void keep(float[] places, float[] xyz) {
        if (channel.isEmpty()) {
            return;
        }
        ByteBuffer record = ByteBuffer.allocate(HEAD_BYTES + Float.BYTES * xyz.length);
        record.putInt(places.length / 3).putLong(checksum(places, xyz));
        record.asFloatBuffer().put(xyz);
        try {
            write(channel.get(), record.rewind());
        } catch (IOException full) {
            keepNoMore();
        }
    }

    private long checksum(float[] places, float[] xyz) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES + Float.BYTES * (places.length + xyz.length));
        bytes.putInt(batch);
        bytes.asFloatBuffer().put(places).put(xyz);
        CRC32 checksum = new CRC32();
        checksum.update(key.getBytes(StandardCharsets.UTF_8));
        checksum.update(bytes.rewind());
        return checksum.getValue();
    }

    /** A disk that is full, or that fails, keeps nobody from making the table. */
    private void keepNoMore() {
        closeFile();
        delete(file);
    }

    private void closeFile() {
        try {
            if (channel.isPresent()) {
                channel.get().close();
            }
        } catch (IOException failure) {
            // What is missing of it is evaluated again.
        } finally {
            channel = Optional.empty();
        }
    }

    /** To be called when the table is made; what cannot be deleted, the cache's limit removes one day. */
    static void delete(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException failure) {
            return;
        }
    }

    @Override
    public void close() {
        closeFile();
        source.ifPresent(ColorSource::close);
    }
}
