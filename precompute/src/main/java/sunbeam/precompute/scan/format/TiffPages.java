package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/**
 * The directories of a TIFF file with all their tags, private ones too, which image readers pass over. Source: Adobe,
 * "TIFF Revision 6.0".
 */
final class TiffPages {
    static final int WIDTH = 256;
    static final int LENGTH = 257;
    static final int BITS = 258;
    private static final int COMPRESSION = 259;
    private static final int STRIP_OFFSETS = 273;
    private static final int STRIP_BYTES = 279;
    static final int SAMPLE_FORMAT = 339;

    private static final int MOST_TAGS = 4096;
    private static final int LONGEST_TEXT = 1 << 16;
    /** Bytes of a value of types 1 to 12. */
    private static final int[] SIZES = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8};

    private TiffPages() {}

    private record Strip(long offset, int count) {}

    record Tag(int type, long count, long position) {}

    record Page(ScanBytes file, ByteOrder order, Map<Integer, Tag> tags) {
        boolean has(int tag) {
            return tags.containsKey(tag);
        }

        /** The tag's first value; 0 without it. */
        double number(int tag) throws IOException {
            return has(tag) ? number(tags.get(tag), 0) : 0;
        }

        private double number(Tag tag, long index) throws IOException {
            if (index >= tag.count) {
                throw new ScanException("has a TIFF tag without value; the file is damaged, export it again");
            }
            ByteCursor cursor = file.cursor(tag.position + index * SIZES[tag.type], order);
            return switch (tag.type) {
                case 1, 7 -> cursor.unsignedByte();
                case 3 -> cursor.unsigned16();
                case 4 -> cursor.unsigned32();
                case 6 -> (byte) cursor.unsignedByte();
                case 8 -> cursor.int16();
                case 9 -> cursor.int32();
                case 11 -> cursor.float32();
                case 12 -> cursor.float64();
                default -> throw new ScanException("has a text where a TIFF tag should be a number; export it again");
            };
        }

        /** The tag's text; empty without it. */
        String text(int tag) throws IOException {
            Tag found = tags.get(tag);
            return found == null || found.type != 2
                    ? ""
                    : file.cursor(found.position, order).text((int) Math.min(found.count, LONGEST_TEXT));
        }

        long position(int tag) {
            return tags.get(tag).position;
        }

        long bytes(int tag) {
            return tags.get(tag).count * SIZES[tags.get(tag).type];
        }

        /** The samples of an uncompressed image of one band, row by row. */
        Samples samples() throws IOException {
            int columns = (int) number(WIDTH);
            int rows = (int) number(LENGTH);
            ScanLimits.requireSize(columns, rows);
            SampleType type = sampleType();
            List<Strip> strips = strips(type, (long) columns * rows);
            return new Samples(columns, rows, () -> {
                double[] samples = new double[columns * rows];
                int first = 0;
                for (Strip strip : strips) {
                    double[] some = type.read(file.stream(strip.offset), strip.count, order);
                    System.arraycopy(some, 0, samples, first, some.length);
                    first += some.length;
                }
                return samples;
            });
        }

        private List<Strip> strips(SampleType type, long count) throws IOException {
            Tag offsets = tags.get(STRIP_OFFSETS);
            Tag bytes = tags.get(STRIP_BYTES);
            if (offsets == null || bytes == null || number(COMPRESSION) > 1) {
                throw new ScanException("stores its samples compressed or in tiles; export it again without");
            }
            List<Strip> strips = new ArrayList<>();
            long rest = count;
            for (long i = 0; i < offsets.count && rest > 0; i++) {
                int samples = (int) Math.min(rest, (long) number(bytes, i) / type.size());
                strips.add(new Strip((long) number(offsets, i), samples));
                file.requireInside((long) number(offsets, i), (long) samples * type.size());
                rest -= samples;
            }
            if (rest > 0) {
                throw new ScanException(
                        "has " + rest + " samples fewer than its size asks for; copy or export it again");
            }
            return strips;
        }

        private SampleType sampleType() throws IOException {
            int bits = (int) number(BITS);
            return switch ((int) number(SAMPLE_FORMAT)) {
                case 2 -> SampleType.signed(bits);
                case 3 -> bits == 64 ? SampleType.FLOAT_64 : SampleType.FLOAT_32;
                default ->
                    bits == 8 ? SampleType.UNSIGNED_8 : bits == 16 ? SampleType.UNSIGNED_16 : SampleType.UNSIGNED_32;
            };
        }
    }

    /** Whether one of the first pages of a TIFF file has a tag; false for whatever cannot be read. */
    static boolean has(ScanBytes file, int pages, int tag) throws IOException {
        try {
            boolean tiff = file.size() > 8 && (file.startsWith("II*\0") || file.startsWith("MM\0*"));
            return tiff && read(file, pages).stream().anyMatch(page -> page.has(tag));
        } catch (ScanException damaged) {
            return false;
        }
    }

    /**
     * The first pages of a TIFF file.
     *
     * @throws ScanException when it is damaged, or has more channels than any scan
     */
    static List<Page> read(ScanBytes file, int most) throws IOException {
        ByteOrder order = file.startsWith("II") ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        List<Page> pages = new ArrayList<>();
        Set<Long> visited = new HashSet<>();
        long offset = file.cursor(4, order).unsigned32();
        while (offset != 0 && pages.size() < most) {
            if (!visited.add(offset)) {
                throw new ScanException("has TIFF pages that follow each other in a circle; export it again");
            }
            ScanLimits.requireChannels(visited.size() - 1);
            ByteCursor cursor = file.cursor(offset, order);
            pages.add(new Page(file, order, tags(file, cursor)));
            offset = cursor.unsigned32();
        }
        if (pages.isEmpty()) {
            throw new ScanException("has no TIFF page; copy or export it again");
        }
        return pages;
    }

    private static Map<Integer, Tag> tags(ScanBytes file, ByteCursor cursor) throws IOException {
        int count = cursor.unsigned16();
        if (count > MOST_TAGS) {
            throw new ScanException("claims " + count + " TIFF tags; the file is damaged, export it again");
        }
        Map<Integer, Tag> tags = new HashMap<>();
        for (int i = 0; i < count; i++) {
            int tag = cursor.unsigned16();
            int type = cursor.unsigned16();
            long values = cursor.unsigned32();
            long position = cursor.position();
            if (type < SIZES.length) {
                if (values * SIZES[type] > Integer.BYTES) {
                    position = cursor.unsigned32();
                    file.requireInside(position, values * SIZES[type]);
                } else {
                    cursor.skip(Integer.BYTES);
                }
                tags.put(tag, new Tag(type, values, position));
            } else {
                cursor.skip(Integer.BYTES);
            }
        }
        return tags;
    }
}
