package sunbeam.app.files.cache;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import sunbeam.precompute.colortable.KeptPages;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.table.TableLabel;

/**
 * Pages of one surface's levels of colors in the cache folder. After its head (format, hash of the key, label) the file has
 * records of one length in the order in which pages were made: level, page, checksum (big endian), coefficients as the shader has them. The checksum is of the key, level, page and coefficients: a record that is damaged, cut off or of something else is
 * passed over, and its page made and appended again. One process at a time appends; the others read.
 */
public final class PageFile implements KeptPages {
    private static final String DAMAGED = "cached colors are made again: some are damaged or cut off";
    private static final String FORMAT = "Sunbeam pages 3";
    private static final int HEAD_BYTES = 2 * Integer.BYTES + Long.BYTES;
    // Records that are read or written at once: a megabyte.
    private static final int TOGETHER = 256;

    private final FileChannel channel;
    private final byte[] key;
    private final int recordBytes;
    private final long start;
    private final long mostBytes;
    private final Consumer<String> warning;
    private final Runnable closed;
    // Where each page's record begins, by level and page.
    private final Map<Long, Long> records = new HashMap<>();
    private boolean writable;
    private boolean warned;

    private PageFile(
            FileChannel channel,
            String key,
            NumberFormat numbers,
            long start,
            long mostBytes,
            Consumer<String> warning,
            Runnable closed,
            boolean writable) {
        this.channel = channel;
        this.key = key.getBytes(StandardCharsets.UTF_8);
        this.recordBytes = HEAD_BYTES + numbers.bytes() * LevelBaking.PAGE_NUMBERS;
        this.start = start;
        this.mostBytes = mostBytes;
        this.warning = warning;
        this.closed = closed;
        this.writable = writable;
    }

    /**
     * Goes on with a file, or begins one. Where that cannot be done, nothing is kept.
     *
     * @param key all that determines the pages
     * @param numbers of their coefficients
     * @param mostBytes that the file may take
     * @param warning told in one line, once, what is wrong with it
     * @param closed told when it has been closed
     */
    public static KeptPages of(
            Path file,
            String key,
            NumberFormat numbers,
            TableLabel label,
            long mostBytes,
            Consumer<String> warning,
            Runnable closed) {
        FileChannel channel = null;
        try {
            channel = FileChannel.open(
                    file,
                    StandardOpenOption.CREATE,
                    StandardOpenOption.READ,
                    StandardOpenOption.WRITE,
                    // A link's target is somebody's file.
                    LinkOption.NOFOLLOW_LINKS);
            boolean locked = lock(channel);
            byte[] head = head(key, numbers, label);
            boolean isDamaged = false;
            if (!isHead(channel, head)) {
                if (!locked) {
                    channel.close();
                    return NONE;
                }
                isDamaged = channel.size() > 0;
                channel.truncate(0);
                write(channel, ByteBuffer.wrap(head), 0);
            }
            PageFile pages = new PageFile(channel, key, numbers, head.length, mostBytes, warning, closed, locked);
            pages.list();
            if (isDamaged || (locked && pages.isCutOff())) {
                pages.warn(DAMAGED);
            }
            return pages;
        } catch (IOException failure) {
            closeQuietly(channel);
            return NONE;
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

    private static byte[] head(String key, NumberFormat numbers, TableLabel label) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeUTF(FORMAT);
        out.writeUTF(label.patch());
        out.writeUTF(label.what());
        out.writeUTF(Sha256.of(key + numbers + ByteOrder.nativeOrder()));
        return bytes.toByteArray();
    }

    private static boolean isHead(FileChannel channel, byte[] head) throws IOException {
        ByteBuffer found = ByteBuffer.allocate(head.length);
        return read(channel, found, 0) && Arrays.equals(found.array(), head);
    }

    /** As {@link CacheEntry#label}. */
    static TableLabel labelOf(Path file) {
        return CacheEntry.labelOf(file, FORMAT);
    }

    /** Whether it ends within a record. Whoever writes at the moment may be in the middle of one. */
    private boolean isCutOff() throws IOException {
        return (channel.size() - start) % recordBytes != 0;
    }

    /** Finds what there is; of a record that was cut off, the rest is overwritten. */
    private void list() throws IOException {
        ByteBuffer head = ByteBuffer.allocate(2 * Integer.BYTES);
        long last = channel.size() - recordBytes;
        for (long at = start; at <= last; at += recordBytes) {
            if (read(channel, head.clear(), at)) {
                head.flip();
                records.put(number(head.getInt(), head.getInt()), at);
            }
        }
    }

    private static long number(int level, int page) {
        return (long) level << Integer.SIZE | page;
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

    @Override
    public BitSet kept(int level, BitSet pages) {
        BitSet kept = new BitSet();
        pages.stream().filter(page -> records.containsKey(number(level, page))).forEach(kept::set);
        return kept;
    }

    @Override
    public Map<Integer, byte[]> read(int level, BitSet pages) {
        int[] inFile = kept(level, pages).stream()
                .boxed()
                .sorted(Comparator.comparing((Integer page) -> records.get(number(level, page))))
                .mapToInt(Integer::intValue)
                .toArray();
        Map<Integer, byte[]> found = new HashMap<>();
        for (int from = 0; from < inFile.length; ) {
            long at = records.get(number(level, inFile[from]));
            int to = from + 1;
            while (to < inFile.length
                    && to - from < TOGETHER
                    && records.get(number(level, inFile[to])) == at + (long) (to - from) * recordBytes) {
                to++;
            }
            read(level, Arrays.copyOfRange(inFile, from, to), at, found);
            from = to;
        }
        return found;
    }

    /** Reads pages that follow each other in the file. */
    private void read(int level, int[] pages, long at, Map<Integer, byte[]> found) {
        ByteBuffer bytes = ByteBuffer.allocate(pages.length * recordBytes);
        try {
            read(channel, bytes, at);
        } catch (IOException failure) {
            // What was not read is found to be damaged.
        }
        byte[][] colors = new byte[pages.length][];
        IntStream.range(0, pages.length)
                .parallel()
                .forEach(i -> colors[i] = coefficients(level, pages[i], bytes.slice(i * recordBytes, recordBytes)));
        for (int i = 0; i < pages.length; i++) {
            if (colors[i].length == 0) {
                records.remove(number(level, pages[i]));
                warn(DAMAGED);
            } else {
                found.put(pages[i], colors[i]);
            }
        }
    }

    /** None unless the record is whole and of this page. */
    private byte[] coefficients(int level, int page, ByteBuffer record) {
        boolean right = record.getInt(0) == level
                && record.getInt(Integer.BYTES) == page
                && record.getLong(2 * Integer.BYTES) == checksum(record);
        byte[] colors = new byte[right ? recordBytes - HEAD_BYTES : 0];
        record.get(HEAD_BYTES, colors);
        return colors;
    }

    /** Of key, level, page and coefficients. */
    private long checksum(ByteBuffer record) {
        CRC32 checksum = new CRC32();
        checksum.update(key);
        checksum.update(record.slice(0, 2 * Integer.BYTES));
        checksum.update(record.slice(HEAD_BYTES, recordBytes - HEAD_BYTES));
        return checksum.getValue();
    }

    @Override
    public void keep(int level, Map<Integer, byte[]> pages) {
        int[] missing = pages.keySet().stream()
                .filter(page -> !records.containsKey(number(level, page)))
                .mapToInt(Integer::intValue)
                .toArray();
        for (int from = 0; writable && from < missing.length; from += TOGETHER) {
            int[] some = Arrays.copyOfRange(missing, from, Math.min(missing.length, from + TOGETHER));
            try {
                append(level, some, pages);
            } catch (IOException failure) {
                writable = false;
                warn("colors are not kept: " + failure.getMessage());
            }
        }
    }

    private void append(int level, int[] pages, Map<Integer, byte[]> coefficients) throws IOException {
        long whole = (channel.size() - start) / recordBytes;
        long at = start + whole * recordBytes;
        int count = (int) Math.min(pages.length, Math.max(0, (mostBytes - at) / recordBytes));
        if (count < pages.length) {
            writable = false;
        }
        ByteBuffer bytes = ByteBuffer.allocate(count * recordBytes);
        IntStream.range(0, count)
                .parallel()
                .forEach(i ->
                        record(level, pages[i], coefficients.get(pages[i]), bytes.slice(i * recordBytes, recordBytes)));
        write(channel, bytes, at);
        for (int i = 0; i < count; i++) {
            records.put(number(level, pages[i]), at + (long) i * recordBytes);
        }
    }

    private void record(int level, int page, byte[] coefficients, ByteBuffer record) {
        record.putInt(level).putInt(page).put(HEAD_BYTES, coefficients);
        record.putLong(2 * Integer.BYTES, checksum(record));
    }

    private void warn(String line) {
        if (!warned) {
            warned = true;
            warning.accept(line);
        }
    }

    private static void closeQuietly(FileChannel channel) {
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
        if (channel.isOpen()) {
            closeQuietly(channel);
            closed.run();
        }
    }
}
