package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;
import sunbeam.precompute.scan.ScanLimits;

/**
 * What a TIFF's tags must say before it is decoded. The format can hold far more than heights, and a damaged or hostile
 * one can ask the decoder for any amount of memory.
 */
final class TiffTags {
    private static final int UPRIGHT = BaselineTIFFTagSet.ORIENTATION_ROW_0_TOP_COLUMN_0_LEFT;
    private static final Set<Integer> LOSSY =
            Set.of(BaselineTIFFTagSet.COMPRESSION_OLD_JPEG, BaselineTIFFTagSet.COMPRESSION_JPEG);
    private static final Set<Integer> GREY_RGB_OR_PALETTE = Set.of(
            BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_BLACK_IS_ZERO,
            BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_RGB,
            BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_PALETTE_COLOR);

    private final Path file;
    private final TIFFDirectory directory;

    private TiffTags(Path file, TIFFDirectory directory) {
        this.file = file;
        this.directory = directory;
    }

    /**
     * Checks the tags of the first image.
     *
     * @throws PatchException when heights cannot be read from such an image
     */
    static void require(Path file, ImageReader reader) throws IOException {
        IIOMetadata metadata = reader.getImageMetadata(0);
        TiffTags tags = new TiffTags(file, TIFFDirectory.createFromMetadata(metadata));
        tags.requireLosslessAndUpright();
        tags.requireKnownSamples();
        tags.requireTilesWithinLimits();
    }

    private void requireLosslessAndUpright() {
        if (LOSSY.contains(number(BaselineTIFFTagSet.TAG_COMPRESSION, BaselineTIFFTagSet.COMPRESSION_NONE))) {
            throw new PatchException(
                    file + " is a TIFF with JPEG compression, which falsifies heights; save it with LZW, ZIP or none");
        }
        int meaning = number(
                BaselineTIFFTagSet.TAG_PHOTOMETRIC_INTERPRETATION,
                BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_BLACK_IS_ZERO);
        if (!GREY_RGB_OR_PALETTE.contains(meaning)) {
            throw new PatchException(file + " is a TIFF with photometric interpretation " + meaning
                    + "; save it as grey (black is zero) or RGB");
        }
        int orientation = number(BaselineTIFFTagSet.TAG_ORIENTATION, UPRIGHT);
        if (orientation != UPRIGHT) {
            throw new PatchException(file + " is a TIFF with orientation tag " + orientation
                    + "; save it upright (row 0 on top, column 0 on the left)");
        }
    }

    /** The JDK's reader takes signed bytes and half floats for unsigned integers without a word. */
    private void requireKnownSamples() {
        int bits = number(BaselineTIFFTagSet.TAG_BITS_PER_SAMPLE, 1);
        int format = number(BaselineTIFFTagSet.TAG_SAMPLE_FORMAT, BaselineTIFFTagSet.SAMPLE_FORMAT_UNSIGNED_INTEGER);
        boolean known = switch (format) {
            case BaselineTIFFTagSet.SAMPLE_FORMAT_UNSIGNED_INTEGER -> true;
            case BaselineTIFFTagSet.SAMPLE_FORMAT_SIGNED_INTEGER -> bits == 16;
            case BaselineTIFFTagSet.SAMPLE_FORMAT_FLOATING_POINT -> bits == 32 || bits == 64;
            default -> false;
        };
        if (!known) {
            throw new PatchException(String.format(
                    Locale.ROOT,
                    "%s is a TIFF with %d-bit samples of format %d; save it as 16-bit or 32-bit float",
                    file,
                    bits,
                    format));
        }
    }

    private void requireTilesWithinLimits() {
        long width = number(BaselineTIFFTagSet.TAG_TILE_WIDTH, 1);
        long length = number(BaselineTIFFTagSet.TAG_TILE_LENGTH, 1);
        if (width < 1 || length < 1 || width * length > ScanLimits.MOST_SAMPLES) {
            throw new PatchException(String.format(
                    Locale.ROOT, "%s is a TIFF with tiles of %d x %d samples; save it in strips", file, width, length));
        }
    }

    /** The tag's first value; a tag of another type than a number shows a damaged file. */
    private int number(int tag, int missing) {
        TIFFField field = directory.getTIFFField(tag);
        return field == null || field.getCount() == 0 ? missing : (int) field.getAsLong(0);
    }
}
