package sunbeam.precompute.patch;

import java.nio.file.Path;
import java.util.Locale;

/** How large an image of heights may be; checked from its header, before memory is taken for it. */
final class ImageLimits {
    /** Longest side in samples: three times the longest that AFM software exports. */
    static final int LONGEST_SIDE = 16_384;
    /** Most samples: 8192 x 8192, whose heights take half a gigabyte. */
    static final long MOST_SAMPLES = 1L << 26;
    /** Heights are held twice while they are levelled; arrays this large leave gaps in the heap of about as much. */
    private static final int BYTES_PER_HEIGHT = 3 * Double.BYTES;

    private ImageLimits() {}

    /** Refuses images that are too large, empty or a single sample. */
    static void requireSize(Path file, int columns, int rows) {
        if (columns < 1 || rows < 1) {
            throw new PatchException(
                    "%s claims %d x %d samples; the file is damaged, export it again".formatted(file, columns, rows));
        }
        if (columns > LONGEST_SIDE || rows > LONGEST_SIDE || (long) columns * rows > MOST_SAMPLES) {
            throw new PatchException(
                    ("%s has %d x %d samples; at most %d per side and %d (8192 x 8192) in all can be used,"
                                    + " so crop the scan")
                            .formatted(file, columns, rows, LONGEST_SIDE, MOST_SAMPLES));
        }
        if (columns == 1 && rows == 1) {
            throw new PatchException(file + " has 1 x 1 samples, which is no surface; give at least 2 x 1 samples");
        }
    }

    /**
     * Refuses images that the heap cannot hold while they are decoded and levelled.
     *
     * @param bytesPerPixel memory of one decoded pixel
     * @param heapBytes largest size of the heap
     */
    static void requireMemory(Path file, long pixels, int bytesPerPixel, long heapBytes) {
        long needed = pixels * (bytesPerPixel + BYTES_PER_HEIGHT);
        if (needed > heapBytes) {
            throw new PatchException(String.format(
                    Locale.ROOT,
                    "%s needs %.1f GB of memory, but Java may take %.1f GB; crop the scan or start Java with a larger -Xmx",
                    file,
                    needed / 1e9,
                    heapBytes / 1e9));
        }
    }
}
