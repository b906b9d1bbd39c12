package sunbeam.app.files.input;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import sunbeam.precompute.files.InputException;

/**
 * Reader of PNG, JPEG, BMP, GIF and TIFF files, recognized by their first bytes. It checks sizes before it allocates memory.
 *
 * @param what role in messages, such as "texture"
 * @param mostPixels limit that keeps a small compressed file from taking minutes
 * @param workingBytes bytes per pixel besides the decoder's samples
 */
public record ImageFile(String what, int largestSide, int mostPixels, int workingBytes) {
    // The JDK's readers; plug-ins are untested on damaged files.
    private static final Set<String> FORMATS = Set.of("png", "jpeg", "bmp", "gif", "tif");
    // Warnings of invented pixels; after others, such as surplus bytes, the picture is complete.
    private static final Pattern MISSING = Pattern.compile("Truncated|premature end|profile is invalid");

    /** Reads a picture that Sunbeam has written, or throws an {@link InputException} that may end with the remedy. */
    public static BufferedImage ours(Path file, String remedy) {
        return InputException.naming(file, () -> {
            BufferedImage image = ImageIO.read(file.toFile());
            InputException.refuseIf(image == null, "it is no picture; " + remedy);
            return image;
        });
    }

    /** Throws InputException if the file is missing, no such image, too large for a heap of this size, or damaged. */
    public BufferedImage read(Path file, long heapBytes) {
        InputException.requireRegular(file);
        try (ImageInputStream stream = new FileImageInputStream(file.toFile())) {
            return read(file, reader(file, stream), stream, heapBytes);
        } catch (IOException failure) {
            throw new InputException(
                    what + " " + file + " cannot be read (" + failure.getMessage() + "); check the file", failure);
        }
    }

    private ImageReader reader(Path file, ImageInputStream stream) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            if (FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
                return reader;
            }
        }
        throw new InputException(what + " " + file + " is no PNG, JPEG, BMP, GIF or TIFF; convert it to PNG or JPEG");
    }

    private BufferedImage read(Path file, ImageReader reader, ImageInputStream stream, long heapBytes)
            throws IOException {
        try {
            reader.setInput(stream, true, true);
            requireSize(file, reader, heapBytes);
            List<String> warnings = new ArrayList<>();
            reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
            BufferedImage image = reader.read(0);
            Optional<String> missing = warnings.stream()
                    .filter(warning -> MISSING.matcher(warning).find())
                    .findFirst();
            refuseIf(missing.isPresent(), file, "is damaged (" + missing.orElse("") + "); export it again");
            return image;
        } catch (InputException refused) {
            throw refused;
        } catch (RuntimeException | StackOverflowError | OutOfMemoryError | AssertionError broken) {
            String reason = broken.getMessage() == null ? broken.getClass().getSimpleName() : broken.getMessage();
            throw new InputException(what + " " + file + " is damaged (" + reason + "); export it again", broken);
        } finally {
            reader.dispose();
        }
    }

    private void refuseIf(boolean condition, Path file, String problem) {
        InputException.refuseIf(condition, what + " " + file + " " + problem);
    }

    private void requireSize(Path file, ImageReader reader, long heapBytes) throws IOException {
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        String size = "has " + width + " x " + height + " pixels";
        boolean fits = width > 0 && height > 0 && width <= largestSide && height <= largestSide;
        refuseIf(!fits, file, size + "; make it at most " + largestSide + " x " + largestSide);
        String most = mostPixels / 1_000_000 + " million at most";
        refuseIf((long) width * height > mostPixels, file, size + "; make it smaller, " + most);
        // A tile, which takes memory, may be larger than the picture.
        String tile = reader.getTileWidth(0) + " x " + reader.getTileHeight(0) + " pixels";
        long pixels = Math.max((long) width * height, (long) reader.getTileWidth(0) * reader.getTileHeight(0));
        refuseIf(pixels > mostPixels, file, "has tiles of " + tile + "; save it without tiles");
        Iterator<ImageTypeSpecifier> types = reader.getImageTypes(0);
        refuseIf(!types.hasNext(), file, "has pixels of an unknown kind; convert it to PNG or JPEG");
        SampleModel model = types.next().getSampleModel();
        long bytesPerPixel =
                (long) model.getNumDataElements() * DataBuffer.getDataTypeSize(model.getDataType()) / Byte.SIZE
                        + workingBytes;
        refuseIf(
                pixels > heapBytes / bytesPerPixel,
                file,
                size + ", too many for Java's memory; make it smaller, or give more with SUNBEAM_JAVA_OPTIONS=-Xmx"
                        + 2 * (heapBytes >> 20) + "m");
    }
}
