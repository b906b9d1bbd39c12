package sunbeam.precompute.scan;

import sunbeam.precompute.text.Text;

/** How large heights may be; checked from a file's header, before memory is taken for them. */
public final class ScanLimits {
    /** Longest side in samples: three times the longest that AFM software writes. */
    public static final int LONGEST_SIDE = 16_384;
    /** Most samples: 8192 x 8192, whose heights take half a gigabyte. */
    public static final long MOST_SAMPLES = 1L << 26;
    /** Most channels of a file: five times as many as any instrument records side by side. */
    public static final int MOST_CHANNELS = 256;

    /** Heights are held twice while they are leveled; arrays this large leave gaps in the heap of about as much. */
    private static final int BYTES_PER_HEIGHT = 3 * Double.BYTES;

    private ScanLimits() {}

    /**
     * Refuses what is too large, empty or a single sample.
     *
     * @throws ScanException that says which
     */
    public static void requireSize(long columns, long rows) {
        if (columns < 1 || rows < 1) {
            throw new ScanException(
                    "claims " + columns + " x " + rows + " samples; the file is damaged, export it again");
        }
        if (columns > LONGEST_SIDE || rows > LONGEST_SIDE || columns * rows > MOST_SAMPLES) {
            throw new ScanException("has " + columns + " x " + rows + " samples; at most " + LONGEST_SIDE
                    + " per side and " + MOST_SAMPLES + " (8192 x 8192) in all can be used, so crop the scan");
        }
        if (columns == 1 && rows == 1) {
            throw new ScanException("has 1 x 1 samples, which is no surface; give at least 2 x 1 samples");
        }
    }

    /**
     * Refuses what the heap cannot hold while it is read and leveled.
     *
     * @param samples at most {@link #MOST_SAMPLES}
     * @param otherBytes memory that reading takes beside the heights
     * @throws ScanException with both figures
     */
    public static void requireMemory(long samples, long otherBytes) {
        long needed = samples * BYTES_PER_HEIGHT + otherBytes;
        long heap = Runtime.getRuntime().maxMemory();
        if (needed > heap) {
            throw new ScanException(Text.format(
                    "needs %.1f GB of memory, but Java may take %.1f GB; crop the scan or start Java with a larger -Xmx",
                    needed / 1e9, heap / 1e9));
        }
    }

    /**
     * Refuses more channels than any scan has.
     *
     * @throws ScanException with their number
     */
    public static void requireChannels(long count) {
        if (count > MOST_CHANNELS) {
            throw new ScanException("claims " + count + " channels; at most " + MOST_CHANNELS
                    + " are read, so export the height channel alone");
        }
    }
}
