package sunbeam.precompute.scan;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Readers of TIFF files whose private tags describe the scan. */
final class TiffTagReaders {
    private static final int GRID_WIDTH = 0x8042;
    private static final int GRID_HEIGHT = 0x8043;
    private static final int CHANNEL = 0x8050;
    private static final int RETRACE = 0x8051;
    private static final int CHANNEL_TITLE = 0x8052;
    private static final int SLOTS = 0x8080;
    private static final int DEFAULT_SLOT = 0x8081;
    private static final int FIRST_SLOT = 0x8090;
    private static final int SLOT_STEP = 0x30;
    private static final int MOST_SLOTS = 64;
    // Tags of a slot, relative to its first one, its name.
    private static final int UNIT = 0x12;
    private static final int SCALING = 0x13;
    private static final int MULTIPLIER = 0x14;
    private static final int OFFSET = 0x15;
    private static final int PARK_TAG = 50432;
    private static final int PARK_VERSION = 50433;
    private static final int PARK_DATA = 50434;
    private static final int PARK_HEADER = 50435;
    private static final int PARK_MAGIC = 0x0e031301;
    // Bytes; the last field that is read ends there.
    private static final int LEAST_HEADER = 352;
    private static final int FIRST_VERSION_WITH_TYPES = 0x01000002;
    private static final Map<Integer, SampleType> PARK_TYPES =
            Map.of(0, SampleType.SIGNED_16, 1, SampleType.SIGNED_32, 2, SampleType.FLOAT_32);

    private TiffTagReaders() {}

    /** In some files only the second page has a channel's name. */
    static boolean isJpk(ScanBytes file) throws IOException {
        return TiffPage.has(file, 1, GRID_WIDTH) && (TiffPage.has(file, 1, CHANNEL) || TiffPage.has(file, 2, CHANNEL));
    }

    /**
     * Reads JPK (Bruker NanoWizard) images: a thumbnail with the scan's size in its tags, and channels, from the bottom row, with several
     * scalings ("slots"). Source: JPK, "Image file format specification", tags 0x8000 to 0x80ff.
     */
    static List<ScanChannel> jpk(ScanBytes file) throws IOException {
        List<TiffPage> pages = TiffPage.read(file);
        TiffPage grid = pages.get(0);
        Extent extent = Extent.of(grid.number(GRID_WIDTH, 0), grid.number(GRID_HEIGHT, 0));
        return pages.stream().skip(1).map(page -> channel(page, extent)).toList();
    }

    private static ScanChannel channel(TiffPage page, Extent extent) {
        String title = page.text(CHANNEL_TITLE);
        int slot = slot(page);
        boolean linear = page.text(slot + SCALING).equals("LinearScaling");
        double factor = linear ? page.number(slot + MULTIPLIER, 0) : 1;
        double offset = linear ? page.number(slot + OFFSET, 0) : 0;
        String name = title.isEmpty() ? page.text(CHANNEL) : title;
        // Samples without a scaling are steps of a converter.
        String unit = linear ? page.text(slot + UNIT) : "steps";
        boolean retrace = page.number(RETRACE, 0) != 0;
        return new ScanChannel(name, retrace, page.samples(0).flipRows().scale(factor, offset), extent, unit);
    }

    private static int slot(TiffPage page) {
        String wanted = page.text(DEFAULT_SLOT);
        return IntStream.range(0, (int) Math.min(MOST_SLOTS, page.number(SLOTS, 0)))
                .map(i -> FIRST_SLOT + SLOT_STEP * i)
                .filter(first -> page.text(first).equals(wanted))
                .findFirst()
                .orElseThrow(() ->
                        new ScanException("has a channel without its scaling \"" + wanted + "\"; export it again"));
    }

    static boolean isPark(ScanBytes file) throws IOException {
        return TiffPage.has(file, 1, PARK_TAG) && TiffPage.has(file, 1, PARK_HEADER);
    }

    /**
     * Reads Park Systems' TIFF files: a preview whose private tags hold a header and the samples, from the bottom row. A height is {@code
     * gain (scale sample + offset)}. Source: Park Systems, "TIFF format for XEI", and sample files.
     */
    static List<ScanChannel> park(ScanBytes file) throws IOException {
        TiffPage page = TiffPage.read(file).get(0);
        byte[] data = page.bytes(PARK_DATA);
        byte[] head = page.bytes(PARK_HEADER);
        ByteBuffer header = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN);
        ScanException.refuseIf(
                page.number(PARK_TAG, 0) != PARK_MAGIC || data.length == 0 || head.length < LEAST_HEADER,
                "has no heights in its Park Systems tags; export it again");
        ScanException.refuseIf(
                header.getInt(0) != 0, "holds lines or spectra and no scan; choose the file of the image");
        int columns = header.getInt(100);
        int rows = header.getInt(104);
        boolean forward = header.getInt(128) != 0;
        double gain = header.getDouble(220);
        double scale = header.getDouble(228);
        double offset = gain * header.getDouble(236);
        boolean typed = page.number(PARK_VERSION, 0) >= FIRST_VERSION_WITH_TYPES;
        SampleType type = SampleType.of(PARK_TYPES, typed ? header.getInt(348) : 0);
        ScanLimits.requireSize(columns, rows);
        int count = columns * rows;
        if ((long) count * type.size() > data.length) {
            throw new ScanException("has " + data.length + " bytes of samples where " + columns + " x " + rows
                    + " take " + (long) count * type.size() + "; copy or export it again");
        }
        Samples samples = new Samples(
                columns, rows, () -> type.read(new ByteArrayInputStream(data), count, ByteOrder.LITTLE_ENDIAN));
        Samples heights = samples.flipRows().scale(scale == 0 ? gain : gain * scale, offset);
        Extent extent = Extent.of(1e-6 * header.getDouble(140), 1e-6 * header.getDouble(148));
        return List.of(new ScanChannel(utf16(head, 4, 32), !forward, heights, extent, utf16(head, 244, 8)));
    }

    private static String utf16(byte[] header, int position, int characters) {
        return new String(header, position, 2 * characters, StandardCharsets.UTF_16LE).split("\0", 2)[0];
    }
}
