package sunbeam.app.files.cache;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.zip.CRC32;
import sunbeam.precompute.colourtable.KeptPages;
import sunbeam.precompute.colourtable.LevelBaking;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.table.TableLabel;

/**
 * Pages of one surface's levels of colours in the cache folder. After its head (format, hash of the key, label) the file has
 * records of one length in the order in which pages were made: level, page, checksum, coefficients of X, Y, Z as float32, big
 * endian. The checksum is of the key, level, page and coefficients: a record that is damaged, cut off or of something else is
 * passed over, and its page made and appended again. One process at a time appends; the others read.
 */
public final class PageFile implements KeptPages {
    private static final String FORMAT = "Sunbeam pages 1";
    private static final int CHANNELS = 4;
    private static final int COLOURS = 3;
    private static final int TEXELS = LevelBaking.PAGE_FLOATS / CHANNELS;
    private static final int HEAD_BYTES = 2 * Integer.BYTES + Long.BYTES;
    private static final int RECORD_BYTES = HEAD_BYTES + COLOURS * TEXELS * Float.BYTES;

    private final FileChannel channel;
    private final String key;
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
            long start,
            long mostBytes,
            Consumer<String> warning,
            Runnable closed,
            boolean writable) {
        this.channel = channel;
        this.key = key;
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
     * @param mostBytes that the file may take
     * @param warning told in one line, once, what is wrong with it
     * @param closed told when it has been closed
     */
    public static KeptPages of(
            Path file, String key, TableLabel label, long mostBytes, Consumer<String> warning, Runnable closed) {
        FileChannel channel = null;
        try {
            channel = FileChannel.open(
                    file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
            boolean locked = lock(channel);
            byte[] head = head(key, label);
            if (!isHead(channel, head)) {
                if (!locked) {
                    channel.close();
                    return NONE;
                }
                channel.truncate(0);
                write(channel, ByteBuffer.wrap(head), 0);
            }
            PageFile pages = new PageFile(channel, key, head.length, mostBytes, warning, closed, locked);
            pages.list();
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

    private static byte[] head(String key, TableLabel label) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeUTF(FORMAT);
        out.writeUTF(label.patch());
        out.writeUTF(label.what());
        out.writeUTF(Sha256.of(key));
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

    /** Finds what there is; of a record that was cut off, the rest is overwritten. */
    private void list() throws IOException {
        ByteBuffer head = ByteBuffer.allocate(2 * Integer.BYTES);
        long last = channel.size() - RECORD_BYTES;
        for (long at = start; at <= last; at += RECORD_BYTES) {
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
    public Map<Integer, float[]> read(int level, BitSet pages) {
        Map<Integer, float[]> found = new HashMap<>();
        ByteBuffer record = ByteBuffer.allocate(RECORD_BYTES);
        kept(level, pages).stream().forEach(page -> {
            long at = records.get(number(level, page));
            float[] coefficients = read(level, page, at, record.clear());
            if (coefficients == null) {
                records.remove(number(level, page));
                warn("cached colours are made again: some are damaged");
            } else {
                found.put(page, coefficients);
            }
        });
        return found;
    }

    /** Null unless it is whole and of this page. */
    private float[] read(int level, int page, long at, ByteBuffer record) {
        try {
            if (!read(channel, record, at)) {
                return null;
            }
        } catch (IOException failure) {
            return null;
        }
        record.flip();
        float[] colours = new float[COLOURS * TEXELS];
        record.position(HEAD_BYTES).asFloatBuffer().get(colours);
        boolean right = record.getInt(0) == level
                && record.getInt(Integer.BYTES) == page
                && record.getLong(2 * Integer.BYTES) == checksum(record);
        return right ? spread(colours) : null;
    }

    private static float[] spread(float[] colours) {
        float[] coefficients = new float[LevelBaking.PAGE_FLOATS];
        for (int texel = 0; texel < TEXELS; texel++) {
            System.arraycopy(colours, COLOURS * texel, coefficients, CHANNELS * texel, COLOURS);
        }
        return coefficients;
    }

    /** Of key, level, page and coefficients. */
    private long checksum(ByteBuffer record) {
        CRC32 checksum = new CRC32();
        checksum.update(key.getBytes(StandardCharsets.UTF_8));
        checksum.update(record.slice(0, 2 * Integer.BYTES));
        checksum.update(record.slice(HEAD_BYTES, RECORD_BYTES - HEAD_BYTES));
        return checksum.getValue();
    }

    @Override
    public void keep(int level, int page, float[] coefficients) {
        if (!writable || records.containsKey(number(level, page))) {
            return;
        }
        ByteBuffer record = ByteBuffer.allocate(RECORD_BYTES);
        record.putInt(level).putInt(page).position(HEAD_BYTES);
        for (int texel = 0; texel < TEXELS; texel++) {
            for (int c = 0; c < COLOURS; c++) {
                record.putFloat(coefficients[CHANNELS * texel + c]);
            }
        }
        record.putLong(2 * Integer.BYTES, checksum(record)).rewind();
        try {
            long whole = (channel.size() - start) / RECORD_BYTES;
            long at = start + whole * RECORD_BYTES;
            if (at + RECORD_BYTES > mostBytes) {
                writable = false;
                warn("no more colours are kept: they take as much as the cache may ('sunbeam cache --limit')");
                return;
            }
            write(channel, record, at);
            records.put(number(level, page), at);
        } catch (IOException failure) {
            writable = false;
            warn("colours are not kept: " + failure.getMessage());
        }
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
