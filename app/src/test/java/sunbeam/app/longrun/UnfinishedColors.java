package sunbeam.app.longrun;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;

/** The file of colors of a half made table, as it lies in the cache (sunbeam.app.files.cache.KeptColors). */
final class UnfinishedColors {
    private static final int TEXTS = 3;
    private static final int FLOATS_A_PLACE = 3;
    /** Of a full one: count, checksum, colors. */
    private static final int BYTES_OF_A_BATCH = 12 + (1 << 14) * FLOATS_A_PLACE * Float.BYTES;

    /** Shorter than a batch takes to evaluate: should one be evaluated again, the file is seen without it. */
    private static final long LOOK_EVERY_MILLISECONDS = 5;

    private UnfinishedColors() {}

    static List<Path> find(Path cache) {
        return CachedFiles.find(cache, ".colors");
    }

    /** Whole batches by where they end in the file, with a hash of their content. */
    static Map<String, String> batches(Path file) {
        Map<String, String> batches = new TreeMap<>();
        byte[] bytes;
        try {
            bytes = Files.readAllBytes(file);
        } catch (NoSuchFileException done) {
            return batches;
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            for (int text = 0; text < TEXTS; text++) {
                in.readUTF();
            }
            while (in.available() > 0) {
                int places = in.readInt();
                long checksum = in.readLong();
                byte[] colors = new byte[FLOATS_A_PLACE * Float.BYTES * places];
                in.readFully(colors);
                batches.put("%012d".formatted(bytes.length - in.available()), checksum + " " + Arrays.hashCode(colors));
            }
        } catch (IOException cutOff) {
            // Whole batches only.
            return batches;
        }
        return batches;
    }

    /** How many batches there are, by the file's length. */
    static int count(Path cache) {
        return find(cache).stream()
                .mapToInt(file -> (int) (file.toFile().length() / BYTES_OF_A_BATCH))
                .sum();
    }

    /** Whether finished batches are made again while a process works: then the file is shorter for a while. */
    static Watch watch(Path cache) {
        long kept = find(cache).stream()
                .flatMap(file -> batches(file).keySet().stream())
                .mapToLong(Long::parseLong)
                .max()
                .orElse(0);
        return new Watch(cache, kept);
    }

    /** Looks at nothing. */
    static Watch nothing() {
        return new Watch(Path.of("none"), 0);
    }

    /** Looks on while a process works. */
    static final class Watch implements AutoCloseable {
        private final CompletableFuture<Void> looking;
        private volatile boolean ended;
        private volatile String complaint = "";

        private Watch(Path cache, long kept) {
            looking = CompletableFuture.runAsync(() -> look(cache, kept));
        }

        private void look(Path cache, long kept) {
            while (!ended && kept > 0) {
                for (Path file : find(cache)) {
                    // 0 where it has gone: the table is there.
                    long length = file.toFile().length();
                    if (length > 0 && length < kept) {
                        complaint = file + " had " + kept + " bytes of finished batches, then " + length;
                    }
                }
                try {
                    Thread.sleep(LOOK_EVERY_MILLISECONDS);
                } catch (InterruptedException stop) {
                    return;
                }
            }
        }

        /** What it saw that must not be, or nothing. */
        String complaint() {
            return complaint;
        }

        @Override
        public void close() {
            ended = true;
            looking.join();
        }
    }
}
