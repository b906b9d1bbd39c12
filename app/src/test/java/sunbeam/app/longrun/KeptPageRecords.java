package sunbeam.app.longrun;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;

/** The records of a file of pages in the cache (sunbeam.app.files.cache.PageFile). */
final class KeptPageRecords {
    private static final int TEXTS = 4;
    private static final int BYTES_OF_A_PAGE = LevelBaking.PAGE_NUMBERS * NumberFormat.HALF.bytes();
    /** Level, page, checksum, colors. */
    private static final int BYTES_OF_A_RECORD = 16 + BYTES_OF_A_PAGE;

    private KeptPageRecords() {}

    static List<Path> find(Path cache) {
        return CachedFiles.find(cache, ".pages");
    }

    /** Whole records by level and page, with checksum and a hash of the colors; one that was made twice stands there twice. */
    static Map<String, String> of(Path file) {
        Map<String, String> records = new TreeMap<>();
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(Files.readAllBytes(file)))) {
            for (int text = 0; text < TEXTS; text++) {
                in.readUTF();
            }
            while (in.available() >= BYTES_OF_A_RECORD) {
                String place = in.readInt() + " " + in.readInt();
                long checksum = in.readLong();
                String content = checksum + " " + Arrays.hashCode(in.readNBytes(BYTES_OF_A_PAGE));
                records.merge(place, content, (one, other) -> one + " and again " + other);
            }
        } catch (IOException cutOff) {
            // A head that was cut off: nothing yet.
            return records;
        }
        return records;
    }

    /** About how many there are, by the files' lengths. */
    static int count(Path cache) {
        return find(cache).stream()
                .mapToInt(file -> (int) (file.toFile().length() / BYTES_OF_A_RECORD))
                .sum();
    }
}
