package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of JPK (Bruker NanoWizard) images: TIFF files whose first page is a thumbnail with the scan's size in its tags. The others are
 * channels, from the bottom row, each with several scalings ("slots"). Source: JPK, "Image file format specification", tags 0x8000 to
 * 0x80ff.
 */
final class JpkReader {
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
    /** Tags of a slot, relative to its first one, its name. */
    private static final int UNIT = 0x12;

    private static final int SCALING = 0x13;
    private static final int MULTIPLIER = 0x14;
    private static final int OFFSET = 0x15;

    private JpkReader() {}

    /** In some files only the second page has a channel's name. */
    static boolean recognizes(ScanBytes file) throws IOException {
        return TiffPage.has(file, 1, GRID_WIDTH) && (TiffPage.has(file, 1, CHANNEL) || TiffPage.has(file, 2, CHANNEL));
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        List<TiffPage> pages = TiffPage.read(file);
        TiffPage grid = pages.get(0);
        Extent extent = Extent.of(grid.number(GRID_WIDTH, 0), grid.number(GRID_HEIGHT, 0));
        List<ScanChannel> channels = new ArrayList<>();
        for (TiffPage page : pages.subList(1, pages.size())) {
            channels.add(channel(page, extent));
        }
        return channels;
    }

    private static ScanChannel channel(TiffPage page, Extent extent) throws IOException {
        String title = page.text(CHANNEL_TITLE);
        int slot = slot(page);
        boolean linear = page.text(slot + SCALING).equals("LinearScaling");
        double factor = linear ? page.number(slot + MULTIPLIER, 0) : 1;
        double offset = linear ? page.number(slot + OFFSET, 0) : 0;
        return new ScanChannel(
                title.isEmpty() ? page.text(CHANNEL) : title,
                page.number(RETRACE, 0) != 0,
                page.samples(0).flipRows().scale(factor, offset),
                extent,
                // Samples without a scaling are steps of a converter.
                linear ? page.text(slot + UNIT) : "steps");
    }

    private static int slot(TiffPage page) throws IOException {
        String wanted = page.text(DEFAULT_SLOT);
        int count = (int) Math.min(MOST_SLOTS, page.number(SLOTS, 0));
        for (int i = 0; i < count; i++) {
            int first = FIRST_SLOT + SLOT_STEP * i;
            if (page.text(first).equals(wanted)) {
                return first;
            }
        }
        throw new ScanException("has a channel without its scaling \"" + wanted + "\"; export it again");
    }
}
