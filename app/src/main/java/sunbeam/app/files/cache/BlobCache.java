package sunbeam.app.files.cache;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.zip.CRC32C;
import java.util.zip.CheckedOutputStream;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableLabel;

/**
 * What a build of the program computes alike each time, kept in the cache folder: textures that it draws, heights of its own patches, the
 * sky that a mesh sees. A file has a head as those of tiles (format, label, hash of the key), the bytes, and the CRC-32C of
 * all before (int64, big endian). Of a program that does not run from a jar nobody knows whether it is the same: it keeps nothing.
 */
public record BlobCache(Optional<String> build, CacheFolder folder, Consumer<String> warning) {
    /** Makes all anew. */
    public static final BlobCache NONE = new BlobCache(Optional.empty(), new CacheFolder(Path.of(""), ""), line -> {});

    private static final String FORMAT = "Sunbeam bytes 1";
    // At most, of a file's beginning and end.
    private static final int HEAD_BYTES = 4096;
    private static final int DIGEST_BYTES = 32;
    // Of heights: their numbers, distances and fingerprint.
    private static final int GRID_BYTES = 2 * Integer.BYTES + 2 * Double.BYTES + DIGEST_BYTES;
    private static final int MOST_HEIGHTS = 1 << 22;
    private static final int MOST_NUMBERS = 1 << 10;

    /** Those of this program. */
    public static BlobCache of(Environment environment, Consumer<String> warning) {
        return new BlobCache(jars(System.getProperty("java.class.path")), CacheFolder.of(environment), warning);
    }

    /** Name, size and time of all jars that the program runs from; nothing where it runs from a folder of classes. */
    static Optional<String> jars(String classPath) {
        StringBuilder found = new StringBuilder();
        for (String entry : classPath.split(File.pathSeparator, -1)) {
            File jar = new File(entry);
            if (!jar.isFile()) {
                return Optional.empty();
            }
            found.append(jar.getName()).append(jar.length()).append('@').append(jar.lastModified());
        }
        return Optional.of(found.toString());
    }

    /**
     * Bytes as they were kept; else they are made, and kept.
     *
     * @param name all that determines them but the program, for people, too
     * @param most there are
     */
    public byte[] get(String name, int most, Supplier<byte[]> made) {
        Optional<Path> opened = build.flatMap(known -> folder.open(BlobCache::isSaidOfTables));
        if (opened.isEmpty()) {
            return made.get();
        }
        String hash = Sha256.of(name + "|" + build.get());
        Path file = opened.get().resolve(CacheEntry.name(hash));
        return folder.read(file, path -> read(path, hash, most), warning).orElseGet(() -> {
            byte[] bytes = made.get();
            folder.save(file, path -> write(path, name, hash, bytes), BlobCache::isSaidOfTables);
            return bytes;
        });
    }

    /** As {@link sunbeam.precompute.patch.HeightCache}. */
    public HeightMap heights(String name, Supplier<HeightMap> generated) {
        int most = GRID_BYTES + Double.BYTES * MOST_HEIGHTS;
        ByteBuffer all = ByteBuffer.wrap(get("heights of " + name, most, () -> toBytes(generated.get())));
        int columns = all.getInt();
        int rows = all.getInt();
        double pitchX = all.getDouble();
        double pitchY = all.getDouble();
        byte[] digest = new byte[DIGEST_BYTES];
        all.get(digest);
        double[] heights = new double[all.remaining() / Double.BYTES];
        all.asDoubleBuffer().get(heights);
        return HeightMap.owning(columns, rows, pitchX, pitchY, heights)
                .withDigest(HexFormat.of().formatHex(digest));
    }

    private static byte[] toBytes(HeightMap map) {
        ByteBuffer all = ByteBuffer.allocate(GRID_BYTES + Double.BYTES * map.heights().length);
        all.putInt(map.columns()).putInt(map.rows());
        all.putDouble(map.pitchX()).putDouble(map.pitchY());
        all.put(HexFormat.of().parseHex(map.digest()));
        all.asDoubleBuffer().put(map.heights());
        return all.array();
    }

    /** As {@link sunbeam.precompute.plan.StatisticsCache}. */
    public double[] numbers(HeightMap map, String name, Supplier<double[]> found) {
        ByteBuffer all = ByteBuffer.wrap(get(name + " of " + map.digest(), MOST_NUMBERS, () -> {
            double[] numbers = found.get();
            ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES * numbers.length);
            bytes.asDoubleBuffer().put(numbers);
            return bytes.array();
        }));
        double[] numbers = new double[all.remaining() / Double.BYTES];
        all.asDoubleBuffer().get(numbers);
        return numbers;
    }

    /** Why nothing can be kept, whose tables are not kept says once. */
    private static void isSaidOfTables(String line) {}

    private static void write(Path file, String name, String hash, byte[] bytes) {
        CRC32C checksum = new CRC32C();
        try (OutputStream plain = Files.newOutputStream(file);
                DataOutputStream out = new DataOutputStream(new CheckedOutputStream(plain, checksum))) {
            TileFile.writeHead(out, FORMAT, new TableLabel("", name), hash);
            out.write(bytes);
            out.writeLong(checksum.getValue());
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot write " + file + ": " + failure.getMessage(), failure);
        }
    }

    static TableLabel label(Path file) {
        return TileFile.labelOf(file, FORMAT);
    }

    private static byte[] read(Path file, String hash, int most) {
        try {
            // Before memory is taken for it.
            if (Files.size(file) > (long) most + HEAD_BYTES) {
                throw new TableException(file + ": is something else");
            }
            byte[] all = Files.readAllBytes(file);
            int end = Math.max(0, all.length - Long.BYTES);
            CRC32C checksum = new CRC32C();
            checksum.update(all, 0, end);
            DataInputStream head = new DataInputStream(new ByteArrayInputStream(all, 0, end));
            boolean right = end > 0
                    && checksum.getValue() == ByteBuffer.wrap(all).getLong(end)
                    && head.readUTF().equals(FORMAT)
                    && head.skip(head.readUnsignedShort()) >= 0
                    && head.skip(head.readUnsignedShort()) >= 0
                    && head.readUTF().equals(hash);
            if (!right) {
                throw new TableException(file + ": is damaged");
            }
            return Arrays.copyOfRange(all, end - head.available(), end);
        } catch (IOException failure) {
            throw new TableException(file + ": cannot be read: " + failure.getMessage());
        }
    }
}
