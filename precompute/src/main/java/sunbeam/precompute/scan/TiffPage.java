package sunbeam.precompute.scan;

import com.twelvemonkeys.imageio.metadata.CompoundDirectory;
import com.twelvemonkeys.imageio.metadata.Directory;
import com.twelvemonkeys.imageio.metadata.Entry;
import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import com.twelvemonkeys.imageio.metadata.tiff.TIFFReader;
import com.twelvemonkeys.imageio.plugins.tiff.TIFFImageReaderSpi;
import java.awt.image.Raster;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.Array;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import sunbeam.precompute.text.Text;

/**
 * Page of a TIFF or BigTIFF file, which TwelveMonkeys decodes after a check of sizes and tags. Source: Adobe, "TIFF Revision 6.0" and its
 * technical notes.
 */
record TiffPage(ScanBytes file, int index, Directory tags) {
    private static final int UNSIGNED = 1;
    private static final int SIGNED = 2;
    private static final int FLOAT = 3;
    private static final int UNCOMPRESSED = 1;
    // None, LZW, ZIP (two codes) and PackBits.
    private static final Set<Integer> LOSSLESS = Set.of(UNCOMPRESSED, 5, 8, 32_946, 32_773);
    private static final int MAX_BANDS = 4;
    private static final int GDAL_NO_DATA = 42_113;
    // Number in the head of a BigTIFF file; TIFF has 42.
    private static final int BIG_TIFF = 43;

    /** True if a tag is on the first {@code pages} pages; false for unreadable files. */
    static boolean has(ScanBytes file, int pages, int tag) throws IOException {
        try {
            return file.startsWith("II*\0", "MM\0*", "II+\0", "MM\0+")
                    && read(file).stream().limit(pages).anyMatch(page -> page.has(tag));
        } catch (ScanException damaged) {
            return false;
        }
    }

    static List<TiffPage> read(ScanBytes file) throws IOException {
        ChannelList.requireCount(pageCount(file));
        List<TiffPage> pages = new ArrayList<>();
        try (ImageInputStream in = new BoundedInput(file.path().toFile())) {
            CompoundDirectory all = (CompoundDirectory) new TIFFReader().read(in);
            for (int i = 0; i < all.directoryCount(); i++) {
                pages.add(new TiffPage(file, i, all.getDirectory(i)));
            }
        } catch (ScanException refused) {
            throw refused;
        } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError | AssertionError broken) {
            throw damaged(broken);
        }
        ScanException.refuseIf(pages.isEmpty(), "has no TIFF page; copy or export it again");
        return pages;
    }

    /** Counts the pages up to the first that is too many, damaged or a repetition, before the library reads all their tags. */
    private static int pageCount(ScanBytes file) throws IOException {
        Set<Long> pages = new HashSet<>();
        try {
            byte[] head = file.read(0, 4).array();
            ScanBytes.Cursor cursor = file.cursor(4, head[0] == 'M' ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
            boolean big = head[2] + head[3] == BIG_TIFF;
            cursor.skip(big ? 4 : 0);
            long page = big ? cursor.int64() : cursor.unsigned32();
            while (page != 0 && pages.add(page) && pages.size() <= ChannelList.MOST_CHANNELS) {
                long tags = big ? cursor.at(page).int64() : cursor.at(page).unsigned16();
                file.requireInside(page, tags);
                cursor.skip(tags * (big ? 20 : 12));
                page = big ? cursor.int64() : cursor.unsigned32();
            }
        } catch (ScanException damaged) {
            // The library reports it.
        }
        return pages.size();
    }

    private static ScanException damaged(Throwable broken) {
        return new ScanException(
                "is a damaged TIFF, or of a kind that cannot be read; copy it again, or save it as gray with ZIP or without compression",
                broken);
    }

    boolean has(int tag) {
        return tags.getEntryById(tag) != null;
    }

    double[] numbers(int tag) {
        Entry entry = tags.getEntryById(tag);
        Object value = entry == null ? new double[0] : entry.getValue();
        try {
            return value instanceof Number number
                    ? new double[] {number.doubleValue()}
                    : IntStream.range(0, Array.getLength(value))
                            .mapToDouble(i -> ((Number) Array.get(value, i)).doubleValue())
                            .toArray();
        } catch (IllegalArgumentException | ClassCastException none) {
            throw new ScanException("has a TIFF tag " + tag + " whose value is not a number; export it again", none);
        }
    }

    double number(int tag, double otherwise) {
        double[] numbers = numbers(tag);
        return numbers.length == 0 ? otherwise : numbers[0];
    }

    /** Returns "" for a missing tag. */
    String text(int tag) {
        Entry entry = tags.getEntryById(tag);
        return entry != null && entry.getValue() instanceof String text ? text : "";
    }

    byte[] bytes(int tag) {
        Entry entry = tags.getEntryById(tag);
        return entry != null && entry.getValue() instanceof byte[] bytes ? bytes : new byte[0];
    }

    int columns() {
        return (int) number(TIFF.TAG_IMAGE_WIDTH, 0);
    }

    int rows() {
        return (int) number(TIFF.TAG_IMAGE_HEIGHT, 0);
    }

    int bands() {
        return (int) number(TIFF.TAG_SAMPLES_PER_PIXEL, 1);
    }

    int bits() {
        return (int) number(TIFF.TAG_BITS_PER_SAMPLE, 1);
    }

    private int format() {
        return (int) number(TIFF.TAG_SAMPLE_FORMAT, UNSIGNED);
    }

    boolean isFloat() {
        return format() == FLOAT;
    }

    Samples samples(int band) {
        requireReadable();
        int count = columns() * rows();
        Samples stored = new Samples(
                columns(), rows(), () -> raster().getSamples(0, 0, columns(), rows(), band, new double[count]));
        if (bits() == 8 && format() == SIGNED) {
            return stored.map(sample -> (byte) sample).withMissing(missing());
        }
        boolean unsigned32 = bits() == 32 && format() == UNSIGNED;
        return (unsigned32 ? stored.map(sample -> sample < 0 ? sample + 0x1p32 : sample) : stored)
                .withMissing(missing());
    }

    /** Returns the sample that GDAL declares as missing; NaN if there is none. */
    private double missing() {
        double mark = Header.Quantity.of(text(GDAL_NO_DATA).strip())
                .map(Header.Quantity::value)
                .orElse(Double.NaN);
        return isFloat() && bits() == 32 ? (float) mark : mark;
    }

    private Raster raster() {
        ImageReader reader = new TIFFImageReaderSpi().createReaderInstance(null);
        try (ImageInputStream in = ImageIO.createImageInputStream(file.path().toFile())) {
            reader.setInput(in);
            return reader.readRaster(index, null);
        } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError | AssertionError broken) {
            throw damaged(broken);
        } finally {
            reader.dispose();
        }
    }

    private void requireReadable() {
        Samples.requireSize(columns(), rows());
        int compression = (int) number(TIFF.TAG_COMPRESSION, UNCOMPRESSED);
        ScanException.refuseIf(
                compression == 6 || compression == 7,
                "has JPEG compression, which changes heights; save it with LZW, ZIP or none");
        ScanException.refuseIf(
                !LOSSLESS.contains(compression),
                "is a TIFF with compression " + compression + "; save it with LZW, ZIP or none");
        int orientation = (int) number(TIFF.TAG_ORIENTATION, 1);
        ScanException.refuseIf(
                orientation > 1,
                "is a TIFF with orientation tag " + orientation
                        + "; save it upright (row 0 on top, column 0 on the left)");
        boolean sameBitDepth =
                Arrays.stream(numbers(TIFF.TAG_BITS_PER_SAMPLE)).distinct().count() <= 1;
        boolean known = isFloat()
                ? Set.of(16, 32, 64).contains(bits())
                : Set.of(UNSIGNED, SIGNED).contains(format())
                        && Set.of(8, 16, 32).contains(bits());
        ScanException.refuseIf(
                !known || !sameBitDepth,
                "is a TIFF with " + (sameBitDepth ? bits() + "-bit" : "differently sized") + " samples of format "
                        + format() + "; save it as integers of 8, 16 or 32 bits or floats of 16, 32 or 64");
        ScanException.refuseIf(
                bands() < 1 || bands() > MAX_BANDS, "has " + bands() + " channels; save it as gray or RGB");
        double tile = number(TIFF.TAG_TILE_WIDTH, 0) * number(TIFF.TAG_TILE_HEIGTH, 0);
        ScanException.refuseIf(
                tile > Samples.MOST_SAMPLES,
                Text.format("is a TIFF with tiles of %.0f samples; save it in strips", tile));
        requireComplete(compression);
        long count = (long) columns() * rows();
        Samples.requireMemory(count, count * bands() * Math.max(bits(), 32) / 8);
    }

    private void requireComplete(int compression) {
        double[] stored = numbers(has(TIFF.TAG_TILE_WIDTH) ? TIFF.TAG_TILE_BYTE_COUNTS : TIFF.TAG_STRIP_BYTE_COUNTS);
        long needed = compression == UNCOMPRESSED ? (long) columns() * rows() * bands() * bits() / Byte.SIZE : 1;
        long bytes = (long) Arrays.stream(stored).sum();
        boolean empty = Arrays.stream(stored).anyMatch(part -> part == 0);
        if (stored.length > 0 && (bytes < needed || bytes > file.size() || empty)) {
            String fault = bytes > file.size()
                    ? "announces " + bytes + " bytes of samples but ends after " + file.size()
                    : empty
                            ? "has no bytes for some strips or tiles"
                            : "has " + bytes + " of " + needed + " bytes of samples";
            throw new ScanException("is a damaged TIFF: it " + fault + "; copy or export it again");
        }
    }

    /** Stream that refuses to read much more than twice the file's size: hostile tags may all refer to the same bytes. */
    private static final class BoundedInput extends FileImageInputStream {
        private long rest = 2 * length() + ScanBytes.LARGEST_HEADER;

        BoundedInput(File file) throws IOException {
            super(file);
        }

        @Override
        public int read(byte[] bytes, int offset, int count) throws IOException {
            rest -= count;
            ScanException.refuseIf(rest < 0, "has TIFF tags larger than the file; it is damaged, export it again");
            return super.read(bytes, offset, count);
        }
    }
}
