package sunbeam.precompute.patch;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.FileImageInputStream;
import sunbeam.precompute.setting.SettingException;

/**
 * Reads heights from PNG, TIFF (the first image of the file) and BMP with 8 or 16 bits per sample, TIFF also with float
 * samples. Samples come out as stored, without gamma or colour management, row 0 on top. Sizes are checked from the
 * header before anything is decoded.
 */
final class HeightImageReader {
    /** Red, green, blue and alpha. */
    private static final int MOST_BANDS = 4;

    private HeightImageReader() {}

    /**
     * The heights in an image file, still without a scale.
     *
     * @param wanted the channel that holds them, where the user says so
     * @throws PatchException when the file is missing, no such image, damaged, too large or lacks the channel
     * @throws SettingException when the channel must be chosen
     */
    static HeightImage read(Path file, Optional<Channel> wanted) {
        InputFiles.requireReadable(file);
        try {
            ImageFormat format = ImageFormat.of(file);
            ImageBands bands = new ImageBands(file, decode(file, format));
            ChannelReader reader = new ChannelReader(file, bands);
            Channel channel = reader.choose(wanted);
            String description = bands.description() + " " + format + ", " + channel.label() + " channel";
            return new HeightImage(bands.columns(), bands.rows(), bands.format(), description, reader.read(channel));
        } catch (PatchException | SettingException e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            // Image decoders answer damaged files with exceptions of many kinds, unchecked ones among them.
            throw new PatchException(
                    String.format(
                            Locale.ROOT,
                            "%s is damaged or of a kind that cannot be read (%s); export the scan again as PNG or TIFF",
                            file,
                            reason(e)),
                    e);
        }
    }

    private static String reason(Exception e) {
        return e.getMessage() == null || e.getMessage().isBlank() ? e.getClass().getSimpleName() : e.getMessage();
    }

    private static BufferedImage decode(Path file, ImageFormat format) throws IOException {
        ImageReader reader = readerFor(format);
        try (FileImageInputStream in = new FileImageInputStream(file.toFile())) {
            // Of metadata only TIFF's are of use; the others could be large.
            reader.setInput(in, true, format != ImageFormat.TIFF);
            int columns = reader.getWidth(0);
            int rows = reader.getHeight(0);
            ImageLimits.requireSize(file, columns, rows);
            if (format == ImageFormat.TIFF) {
                TiffTags.require(file, reader);
            }
            int bytesPerPixel = bytesPerPixel(file, reader);
            ImageLimits.requireMemory(
                    file,
                    (long) columns * rows,
                    bytesPerPixel,
                    Runtime.getRuntime().maxMemory());
            return reader.read(0);
        } finally {
            reader.dispose();
        }
    }

    private static ImageReader readerFor(ImageFormat format) {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format.name());
        if (!readers.hasNext()) {
            throw new IllegalStateException("this Java has no reader for " + format);
        }
        return readers.next();
    }

    private static int bytesPerPixel(Path file, ImageReader reader) throws IOException {
        Iterator<ImageTypeSpecifier> types = reader.getImageTypes(0);
        if (!types.hasNext()) {
            throw new PatchException(file + " stores its samples in an unknown way; save it as grey 8- or 16-bit PNG");
        }
        SampleModel model = types.next().getSampleModel();
        if (model.getNumBands() > MOST_BANDS) {
            throw new PatchException(String.format(
                    Locale.ROOT, "%s has %d channels; save it as grey or RGB", file, model.getNumBands()));
        }
        return model.getNumDataElements() * DataBuffer.getDataTypeSize(model.getDataType()) / Byte.SIZE;
    }
}
