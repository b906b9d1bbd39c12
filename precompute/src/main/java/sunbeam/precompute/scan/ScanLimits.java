package sunbeam.precompute.scan;

import sunbeam.precompute.text.Text;

/** Limits of scans, checked from a file's header before memory is taken. */
public final class ScanLimits {
    /** Samples: three times the longest side that the software of force microscopes writes. */
    public static final int LONGEST_SIDE = 16_384;
    /** 8192 x 8192, whose heights take half a gigabyte. */
    public static final long MOST_SAMPLES = 1L << 26;
    /** Five times as many as any instrument records at once. */
    public static final int MOST_CHANNELS = 256;

    // Leveling holds two arrays of heights; gaps in the heap take up to a third more.
    private static final int BYTES_PER_HEIGHT = 3 * Double.BYTES;

    private ScanLimits() {}

    public static void requireSize(long columns, long rows) {
        ScanException.refuseIf(
                columns < 1 || rows < 1,
                "claims " + columns + " x " + rows + " samples; the file is damaged, export it again");
        ScanException.refuseIf(
                columns > LONGEST_SIDE || rows > LONGEST_SIDE || columns * rows > MOST_SAMPLES,
                "has " + columns + " x " + rows + " samples; at most " + LONGEST_SIDE + " per side and " + MOST_SAMPLES
                        + " (8192 x 8192) in all can be used, so crop the scan");
        ScanException.refuseIf(
                columns == 1 && rows == 1, "has 1 x 1 samples, which is no surface; give at least 2 x 1 samples");
    }

    /** Refuses scans that the heap cannot hold with {@code otherBytes} while they are read and leveled. */
    public static void requireMemory(long samples, long otherBytes) {
        long needed = samples * BYTES_PER_HEIGHT + otherBytes;
        long heap = Runtime.getRuntime().maxMemory();
        if (needed > heap) {
            throw new ScanException(Text.format(
                    "needs %.1f GB of memory, but Java may take %.1f GB; crop the scan or start Java with a larger -Xmx",
                    needed / 1e9, heap / 1e9));
        }
    }

    public static void requireChannels(long count) {
        if (count > MOST_CHANNELS) {
            throw new ScanException("claims " + count + " channels; at most " + MOST_CHANNELS
                    + " are read, so export the height channel alone");
        }
    }
}
