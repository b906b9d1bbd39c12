package sunbeam.app.files.cache;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.zip.CRC32;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.plan.TableLabel;

/**
 * Cache file of a color table's tiles in the order of baking. After the head (format, label, hash of the key) come records: a number made
 * of level and tile, a checksum of key, number and content (both int64, big endian), the tile's coefficients. Damaged records are skipped,
 * their tiles appended again. One process at a time appends; others only read.
 */
public final class TileFile implements CachedTiles {
    private static final String DAMAGED = "cached colors are made again: some are damaged or cut off";
    static final String FORMAT = "Sunbeam records 1";
    private static final int HEAD_BYTES = 2 * Long.BYTES;

    private final CacheFolder folder;
    private final Path file;
    private final FileChannel channel;
    private final byte[] key;
    private final int recordBytes;
    private final long start;
    private final Consumer<String> warning;
    private final Map<Long, Long> records = new HashMap<>();
    private final boolean locked;
    private boolean writable;
    private boolean warned;

    private TileFile(
            CacheFolder folder,
            Path file,
            FileChannel channel,
            String key,
            NumberFormat numbers,
            TableLabel label,
            Consumer<String> warning)
            throws IOException {
        String all = key + numbers + ByteOrder.nativeOrder();
        int contentBytes = numbers.bytes() * LevelBaking.TILE_NUMBERS;
        byte[] head = head(FORMAT, label, Sha256.of(all + "|" + contentBytes));
        this.folder = folder;
        this.file = file;
        this.channel = channel;
        this.key = all.getBytes(StandardCharsets.UTF_8);
        this.recordBytes = HEAD_BYTES + contentBytes;
        this.start = head.length;
        this.warning = warning;
        this.locked = lock(channel);
        this.writable = locked;
        ByteBuffer found = ByteBuffer.allocate(head.length);
        boolean isRight = read(channel, found, 0) && Arrays.equals(found.array(), head);
        if (!isRight && !locked) {
            throw new IOException("another process writes the file");
        }
        boolean isDamaged = !isRight && channel.size() > 0;
        if (!isRight) {
            channel.truncate(0);
            write(channel, ByteBuffer.wrap(head), 0);
        }
        list();
        // Another process may be writing the last record.
        if (isDamaged || (locked && (channel.size() - start) % recordBytes != 0)) {
            warn(DAMAGED);
        }
    }

    /** Opens or creates a file of the folder, which counts as used; if that fails, no tile is cached. */
    public static CachedTiles of(
            CacheFolder folder,
            Path file,
            String key,
            NumberFormat numbers,
            TableLabel label,
            Consumer<String> warning) {
        FileChannel channel = null;
        try {
            if (CacheFolder.isObstructed(file)) {
                warning.accept("colors are not kept: " + CacheFolder.obstruction(file));
                return NONE;
            }
            channel = FileChannel.open(
                    file,
                    StandardOpenOption.CREATE,
                    StandardOpenOption.READ,
                    StandardOpenOption.WRITE,
                    // A link may point to any file.
                    LinkOption.NOFOLLOW_LINKS);
            CacheFolder.makeOwnersOnly(file);
            CachedTiles tiles = new TileFile(folder, file, channel, key, numbers, label, warning);
            folder.used(file);
            folder.shrink(folder.limit(), Optional.of(file));
            return tiles;
        } catch (IOException failure) {
            close(channel);
            return NONE;
        }
    }

    private static boolean lock(FileChannel channel) throws IOException {
        try {
            return channel.tryLock() != null;
        } catch (OverlappingFileLockException another) {
            return false;
        }
    }

    static byte[] head(String format, TableLabel label, String keyHash) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        try {
            for (String word : List.of(format, label.patch(), label.what(), keyHash)) {
                out.writeUTF(word);
            }
        } catch (IOException tooLong) {
            throw new UncheckedIOException("a label of more than 64 KB", tooLong);
        }
        return bytes.toByteArray();
    }

    static TableLabel label(Path file, String format) {
        try (DataInputStream in = new DataInputStream(Files.newInputStream(file))) {
            if (in.readUTF().equals(format)) {
                return new TableLabel(in.readUTF(), in.readUTF());
            }
            throw new InputException(file + ": not of this version");
        } catch (EOFException failure) {
            throw new InputException(file + ": cut off");
        } catch (IOException failure) {
            throw new InputException(file + ": cannot be read: " + failure.getMessage());
        }
    }

    /** The next record overwrites a truncated one at the end. */
    private void list() throws IOException {
        ByteBuffer number = ByteBuffer.allocate(Long.BYTES);
        long last = channel.size() - recordBytes;
        for (long at = start; at <= last; at += recordBytes) {
            if (read(channel, number.clear(), at)) {
                records.put(number.getLong(0), at);
            }
        }
    }

    private static boolean read(FileChannel channel, ByteBuffer bytes, long from) throws IOException {
        long at = from;
        while (bytes.hasRemaining()) {
            int count = channel.read(bytes, at);
            if (count < 0) {
                return false;
            }
            at += count;
        }
        return true;
    }

    private static void write(FileChannel channel, ByteBuffer bytes, long to) throws IOException {
        long at = to;
        while (bytes.hasRemaining()) {
            at += channel.write(bytes, at);
        }
    }

    private static long number(int level, int tile) {
        return (long) level << Integer.SIZE | tile;
    }

    @Override
    public BitSet present(int level, BitSet tiles) {
        BitSet found = new BitSet();
        tiles.stream().filter(tile -> records.containsKey(number(level, tile))).forEach(found::set);
        return found;
    }

    @Override
    public Map<Integer, byte[]> read(int level, BitSet tiles) {
        BitSet there = present(level, tiles);
        Map<Integer, byte[]> found = new ConcurrentHashMap<>();
        there.stream()
                .parallel()
                .forEach(tile -> content(number(level, tile)).ifPresent(content -> found.put(tile, content)));
        there.stream().filter(tile -> !found.containsKey(tile)).forEach(tile -> {
            records.remove(number(level, tile));
            warn(DAMAGED);
        });
        return found;
    }

    private Optional<byte[]> content(long number) {
        ByteBuffer record = ByteBuffer.allocate(recordBytes);
        try {
            boolean whole = read(channel, record, records.get(number));
            byte[] content = Arrays.copyOfRange(record.array(), HEAD_BYTES, recordBytes);
            boolean right =
                    whole && record.getLong(0) == number && record.getLong(Long.BYTES) == checksum(number, content);
            return right ? Optional.of(content) : Optional.empty();
        } catch (IOException failure) {
            return Optional.empty();
        }
    }

    private long checksum(long number, byte[] content) {
        CRC32 checksum = new CRC32();
        checksum.update(key);
        checksum.update(ByteBuffer.allocate(Long.BYTES).putLong(0, number));
        checksum.update(content);
        return checksum.getValue();
    }

    @Override
    public void keep(int level, Map<Integer, byte[]> tiles) {
        try {
            for (Map.Entry<Integer, byte[]> tile : new TreeMap<>(tiles).entrySet()) {
                long number = number(level, tile.getKey());
                if (writable && !records.containsKey(number)) {
                    append(number, tile.getValue());
                }
            }
        } catch (IOException failure) {
            writable = false;
            warn("colors are not kept: " + failure.getMessage());
        }
    }

    @Override
    public void discard() {
        try {
            if (locked) {
                channel.truncate(start);
            }
        } catch (IOException failure) {
            warn("colors that miss their tolerance cannot be removed: " + failure.getMessage());
        }
        records.clear();
        writable = false;
    }

    private void append(long number, byte[] content) throws IOException {
        long at = start + (channel.size() - start) / recordBytes * recordBytes;
        writable = at + recordBytes <= folder.largest();
        if (writable) {
            ByteBuffer record = ByteBuffer.allocate(recordBytes);
            record.putLong(number).putLong(checksum(number, content)).put(content);
            write(channel, record.flip(), at);
            records.put(number, at);
        }
    }

    private void warn(String line) {
        if (!warned) {
            warned = true;
            warning.accept(line);
        }
    }

    private static void close(FileChannel channel) {
        try {
            if (channel != null) {
                channel.close();
            }
        } catch (IOException failure) {
            // A later run bakes the missing tiles again.
        }
    }

    @Override
    public void close() {
        close(channel);
        folder.shrink(folder.limit(), Optional.of(file));
    }
}
