package sunbeam.app.files.cache;

import java.io.File;
import java.io.IOException;
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
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.TableLabel;

/**
 * Cache of bytes that depend only on the build and a name. A file has the head of a {@link TileFile}, the bytes, and the CRC-32C of both
 * (int64, big endian). A program in a folder of classes has no build number, so it caches nothing.
 */
public record BlobCache(Optional<String> build, CacheFolder folder, Consumer<String> warning) {
    public static final BlobCache NONE = new BlobCache(Optional.empty(), new CacheFolder(Path.of(""), ""), line -> {});

    static final String FORMAT = "Sunbeam bytes 1";
    private static final int DIGEST_BYTES = 32;
    private static final int GRID_BYTES = 2 * Integer.BYTES + 2 * Double.BYTES + DIGEST_BYTES;
    private static final int MOST_HEIGHTS = 1 << 22;
    private static final int MOST_NUMBERS = 1 << 10;

    public static BlobCache of(Environment environment, Consumer<String> warning) {
        return new BlobCache(jars(System.getProperty("java.class.path")), CacheFolder.of(environment), warning);
    }

    /** Returns names, sizes and times of all jars; empty if an entry is a folder of classes. */
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

    /** Returns the cached bytes, or makes and caches them. The name is all that determines them besides the build. */
    public byte[] get(String name, int most, Supplier<byte[]> maker) {
        // The cache of tables prints the same warning already.
        Consumer<String> dropped = line -> {};
        Optional<Path> opened = build.flatMap(known -> folder.open(dropped));
        if (opened.isEmpty()) {
            return maker.get();
        }
        String hash = Sha256.of(name + "|" + build.get());
        Path file = opened.get().resolve(CacheFolder.name(hash, CacheFolder.Entry.BYTES));
        byte[] head = TileFile.head(FORMAT, new TableLabel("", name), hash);
        return folder.read(file, path -> read(path, head, most), warning).orElseGet(() -> {
            byte[] bytes = maker.get();
            folder.save(file, path -> write(path, head, bytes), dropped);
            return bytes;
        });
    }

    public HeightMap heights(String name, Supplier<HeightMap> generated) {
        int most = GRID_BYTES + Double.BYTES * MOST_HEIGHTS;
        ByteBuffer all = ByteBuffer.wrap(get("heights of " + name, most, () -> {
            HeightMap map = generated.get();
            ByteBuffer bytes = ByteBuffer.allocate(GRID_BYTES + Double.BYTES * map.heights().length);
            bytes.putInt(map.columns()).putInt(map.rows());
            bytes.putDouble(map.pitchX()).putDouble(map.pitchY());
            bytes.put(HexFormat.of().parseHex(map.digest()));
            bytes.asDoubleBuffer().put(map.heights());
            return bytes.array();
        }));
        int columns = all.getInt();
        int rows = all.getInt();
        double pitchX = all.getDouble();
        double pitchY = all.getDouble();
        byte[] digest = new byte[DIGEST_BYTES];
        all.get(digest);
        return new HeightMap(columns, rows, pitchX, pitchY, doubles(all))
                .withDigest(HexFormat.of().formatHex(digest));
    }

    public double[] numbers(HeightMap map, String name, Supplier<double[]> found) {
        return doubles(ByteBuffer.wrap(get(name + " of " + map.digest(), MOST_NUMBERS, () -> {
            double[] numbers = found.get();
            ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES * numbers.length);
            bytes.asDoubleBuffer().put(numbers);
            return bytes.array();
        })));
    }

    private static double[] doubles(ByteBuffer bytes) {
        double[] doubles = new double[bytes.remaining() / Double.BYTES];
        bytes.asDoubleBuffer().get(doubles);
        return doubles;
    }

    private static void write(Path file, byte[] head, byte[] bytes) {
        ByteBuffer all = ByteBuffer.allocate(head.length + bytes.length + Long.BYTES);
        all.put(head).put(bytes).putLong(checksum(all));
        try {
            Files.write(file, all.array());
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot write " + file + ": " + failure.getMessage(), failure);
        }
    }

    private static long checksum(ByteBuffer all) {
        CRC32C checksum = new CRC32C();
        checksum.update(all.slice(0, all.capacity() - Long.BYTES));
        return checksum.getValue();
    }

    private static byte[] read(Path file, byte[] head, int most) {
        try {
            long size = Files.size(file);
            if (size < head.length + Long.BYTES || size > (long) head.length + most + Long.BYTES) {
                throw new InputException(file + ": is something else");
            }
            ByteBuffer all = ByteBuffer.wrap(Files.readAllBytes(file));
            int end = all.capacity() - Long.BYTES;
            if (all.getLong(end) != checksum(all) || all.slice(0, head.length).compareTo(ByteBuffer.wrap(head)) != 0) {
                throw new InputException(file + ": is damaged");
            }
            return Arrays.copyOfRange(all.array(), head.length, end);
        } catch (IOException failure) {
            throw new InputException(file + ": cannot be read: " + failure.getMessage());
        }
    }
}
