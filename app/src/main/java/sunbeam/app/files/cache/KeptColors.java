package sunbeam.app.files.cache;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.table.TableLabel;

/**
 * Colors of a table that is being made, kept as they come, so that a run after one that was stopped does not evaluate them
 * again. Whoever makes the table asks for the same places in the same order; each batch is a record, X, Y, Z of each place
 * as float32, big endian, and zeros after the last.
 */
final class KeptColors implements ColorSource {
    /** What a GPU draws at once (sunbeam.app.gpu.colors.GpuColors); a batch takes about a tenth of a second on llvmpipe. */
    static final int BATCH = 1 << 14;

    private final Optional<RecordFile> records;
    private final Supplier<ColorSource> making;
    private Optional<ColorSource> source = Optional.empty();
    private long batch;

    private KeptColors(Optional<RecordFile> records, Supplier<ColorSource> making) {
        this.records = records;
        this.making = making;
    }

    /**
     * Goes on with a file, or begins one. A file that cannot be written is not: then nothing is kept.
     *
     * @param key all that determines the colors and their order
     * @param making opened when a color is missing, closed with this
     */
    static KeptColors of(Path file, String key, TableLabel label, Supplier<ColorSource> making) {
        return new KeptColors(
                RecordFile.open(file, key, 3 * Float.BYTES * BATCH, label, Long.MAX_VALUE, line -> {}), making);
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
        Optional<byte[]> kept = records.map(file -> file.read(List.of(batch)).get(batch));
        if (kept.isPresent()) {
            float[] xyz = new float[places.length];
            ByteBuffer.wrap(kept.get()).asFloatBuffer().get(xyz);
            return xyz;
        }
        if (source.isEmpty()) {
            source = Optional.of(making.get());
        }
        float[] xyz = source.get().xyz(places);
        ByteBuffer bytes = ByteBuffer.allocate(3 * Float.BYTES * BATCH);
        bytes.asFloatBuffer().put(xyz);
        records.ifPresent(file -> file.append(Map.of(batch, bytes.array())));
        return xyz;
    }

    /** To be called when the table is made; what cannot be deleted, the cache's limit removes one day. */
    static void delete(Path file) {
        file.toFile().delete();
    }

    @Override
    public void close() {
        records.ifPresent(RecordFile::close);
        source.ifPresent(ColorSource::close);
    }
}
