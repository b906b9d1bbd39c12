package sunbeam.precompute.patch;

import java.nio.file.Path;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/** How large an image of heights may be; checked from its header, before memory is taken for it. */
final class ImageLimits {
    private ImageLimits() {}

    /** Refuses images that are too large, empty or a single sample. */
    static void requireSize(Path file, int columns, int rows) {
        named(file, () -> ScanLimits.requireSize(columns, rows));
    }

    /**
     * Refuses images that the heap cannot hold while they are decoded and levelled.
     *
     * @param bytesPerPixel memory of one decoded pixel
     * @param heapBytes largest size of the heap
     */
    static void requireMemory(Path file, long pixels, int bytesPerPixel, long heapBytes) {
        named(file, () -> ScanLimits.requireMemory(pixels, bytesPerPixel, heapBytes));
    }

    private static void named(Path file, Runnable check) {
        try {
            check.run();
        } catch (ScanException unusable) {
            throw new PatchException(file + " " + unusable.getMessage(), unusable);
        }
    }
}
