package sunbeam.app.files.cache;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.zip.CRC32;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableLabel;

/**
 * What is made piece by piece and kept as it comes: records of one length in a file of the cache, in the order in which they
 * were made. After its head (format, label, hash of the key) each record has a number, a checksum of key, number and content
 * (int64, big endian), and the content. A record that is damaged, cut off or of something else is passed over; it is made and
 * appended again. One process at a time appends; the others read.
 */
final class RecordFile implements AutoCloseable {
    private static final String DAMAGED = "cached colors are made again: some are damaged or cut off";
    private static final String FORMAT = "Sunbeam records 1";
    private static final int HEAD_BYTES = 2 * Long.BYTES;

    private final FileChannel channel;
    private final byte[] key;
    private final int contentBytes;
    private final long start;
    private final long mostBytes;
    private final Consumer<String> warning;
    // Where each record begins, by its number.
    private final Map<Long, Long> records = new HashMap<>();
    private boolean writable;
    private boolean warned;

    private RecordFile(
            FileChannel channel,
            String key,
            int contentBytes,
            long start,
            long mostBytes,
            Consumer<String> warning,
            boolean writable) {
        this.channel = channel;
        this.key = key.getBytes(StandardCharsets.UTF_8);
        this.contentBytes = contentBytes;
        this.start = start;
        this.mostBytes = mostBytes;
        this.warning = warning;
        this.writable = writable;
    }

    /**
     * Goes on with a file, or begins one; nothing where that cannot be done.
     *
     * @param key all that determines the records
     * @param contentBytes of each record
     * @param mostBytes that the file may take
     * @param warning told in one line, once, what is wrong with it
     */
    static Optional<RecordFile> open(
            Path file, String key, int contentBytes, TableLabel label, long mostBytes, Consumer<String> warning) {
        FileChannel channel = null;
        try {
            channel = FileChannel.open(
                    file,
                    Set.of(
                            StandardOpenOption.CREATE,
                            StandardOpenOption.READ,
                            StandardOpenOption.WRITE,
                            // A link's target is somebody's file.
                            LinkOption.NOFOLLOW_LINKS),
                    CacheFolder.ownersOnly(file));
            boolean locked = lock(channel);
            byte[] head = head(key + "|" + contentBytes, label);
            ByteBuffer found = ByteBuffer.allocate(head.length);
            boolean isRight = read(channel, found, 0) && Arrays.equals(found.array(), head);
            if (!isRight && !locked) {
                channel.close();
                return Optional.empty();
            }
            boolean isDamaged = !isRight && channel.size() > 0;
            if (!isRight) {
                channel.truncate(0);
                write(channel, ByteBuffer.wrap(head), 0);
            }
            RecordFile records = new RecordFile(channel, key, contentBytes, head.length, mostBytes, warning, locked);
            records.list();
            // Whoever writes at the moment may be in the middle of a record.
            if (isDamaged || (locked && (channel.size() - head.length) % records.recordBytes() != 0)) {
                records.warn(DAMAGED);
            }
            return Optional.of(records);
        } catch (IOException failure) {
            close(channel);
            return Optional.empty();
        }
    }

    /** Whether this process may append. */
    private static boolean lock(FileChannel channel) throws IOException {
        try {
            return channel.tryLock() != null;
        } catch (OverlappingFileLockException another) {
            return false;
        }
    }

    private static byte[] head(String key, TableLabel label) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeUTF(FORMAT);
        out.writeUTF(label.patch());
        out.writeUTF(label.what());
        out.writeUTF(Sha256.of(key));
        return bytes.toByteArray();
    }

    /**
     * What a file's records are, and for which surface.
     *
     * @throws TableException when the file does not say it
     */
    static TableLabel labelOf(Path file) {
        try (DataInputStream in = new DataInputStream(Files.newInputStream(file))) {
            if (in.readUTF().equals(FORMAT)) {
                return new TableLabel(in.readUTF(), in.readUTF());
            }
            throw new TableException(file + ": no colors of this version");
        } catch (IOException failure) {
            throw new TableException(file + ": cannot be read: " + failure.getMessage());
        }
    }

    private int recordBytes() {
        return HEAD_BYTES + contentBytes;
    }

    /** Finds what there is; of a record that was cut off, the rest is overwritten. */
    private void list() throws IOException {
        ByteBuffer number = ByteBuffer.allocate(Long.BYTES);
        long last = channel.size() - recordBytes();
        for (long at = start; at <= last; at += recordBytes()) {
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

    /** Whether there is a record of a number, as far as is known before it is read. */
    boolean has(long number) {
        return records.containsKey(number);
    }

    /** Those of some records that there are, by number. */
    Map<Long, byte[]> read(Collection<Long> numbers) {
        Map<Long, byte[]> found = new ConcurrentHashMap<>();
        numbers.parallelStream()
                .filter(this::has)
                .forEach(number -> content(number).ifPresent(content -> found.put(number, content)));
        if (records.keySet().removeIf(number -> numbers.contains(number) && !found.containsKey(number))) {
            warn(DAMAGED);
        }
        return found;
    }

    /** Nothing unless the record is whole and of this number. */
    private Optional<byte[]> content(long number) {
        ByteBuffer record = ByteBuffer.allocate(recordBytes());
        try {
            boolean whole = read(channel, record, records.get(number));
            byte[] content = Arrays.copyOfRange(record.array(), HEAD_BYTES, recordBytes());
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

    /** Keeps records that are not there yet, as far as the file has room. */
    void append(Map<Long, byte[]> contents) {
        try {
            for (Map.Entry<Long, byte[]> content : contents.entrySet()) {
                if (writable && !has(content.getKey())) {
                    append(content.getKey(), content.getValue());
                }
            }
        } catch (IOException failure) {
            writable = false;
            warn("colors are not kept: " + failure.getMessage());
        }
    }

    private void append(long number, byte[] content) throws IOException {
        long at = start + (channel.size() - start) / recordBytes() * recordBytes();
        writable = at + recordBytes() <= mostBytes;
        if (writable) {
            ByteBuffer record = ByteBuffer.allocate(recordBytes());
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
            // What is missing of it is made again.
        }
    }

    @Override
    public void close() {
        close(channel);
    }
}
