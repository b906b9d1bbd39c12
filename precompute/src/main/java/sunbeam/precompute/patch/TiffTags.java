package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;

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
     * @param fileBytes size of the file
     * @throws PatchException when heights cannot be read from such an image
     */
    static void require(Path file, ImageReader reader, long fileBytes) throws IOException {
        IIOMetadata metadata = reader.getImageMetadata(0);
        TiffTags tags = new TiffTags(file, TIFFDirectory.createFromMetadata(metadata));
        tags.requireLosslessAndUpright();
        tags.requireDataInside(
                fileBytes, BaselineTIFFTagSet.TAG_STRIP_OFFSETS, BaselineTIFFTagSet.TAG_STRIP_BYTE_COUNTS);
        tags.requireDataInside(fileBytes, BaselineTIFFTagSet.TAG_TILE_OFFSETS, BaselineTIFFTagSet.TAG_TILE_BYTE_COUNTS);
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

    private void requireDataInside(long fileBytes, int offsetsTag, int countsTag) {
        long[] offsets = numbers(offsetsTag);
        long[] counts = numbers(countsTag);
        for (int i = 0; i < Math.min(offsets.length, counts.length); i++) {
            if (offsets[i] < 0 || counts[i] < 0 || offsets[i] + counts[i] > fileBytes) {
                throw new PatchException(
                        file + " is truncated: its image data end beyond the end of the file; export it again");
            }
        }
        // Data that overlap are decoded once per mention: a small file could otherwise stand for a very large one.
        if (Arrays.stream(counts).sum() > fileBytes) {
            throw new PatchException(file + " is damaged: its image data overlap; export it again");
        }
    }

    private void requireTilesWithinLimits() {
        long width = number(BaselineTIFFTagSet.TAG_TILE_WIDTH, 1);
        long length = number(BaselineTIFFTagSet.TAG_TILE_LENGTH, 1);
        if (width < 1 || length < 1 || width * length > ImageLimits.MOST_SAMPLES) {
            throw new PatchException(
                    "%s is a TIFF with tiles of %d x %d samples; save it in strips".formatted(file, width, length));
        }
    }

    private int number(int tag, int missing) {
        long[] values = numbers(tag);
        return values.length == 0 ? missing : (int) values[0];
    }

    private long[] numbers(int tag) {
        TIFFField field = directory.getTIFFField(tag);
        return field == null ? new long[0] : field.getAsLongs();
    }
}
