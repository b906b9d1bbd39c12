package sunbeam.app.files.output;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import sunbeam.app.terminal.Environment;

/** Writer of 8-bit PNG files with an sRGB chunk and text chunks (tEXt, or iTXt beyond Latin-1), by default {@code Software}. */
public final class PngWriter {
    private static final String NATIVE_FORMAT = "javax_imageio_png_1.0";

    private PngWriter() {}

    /** Writes an sRGB picture whole, or throws OutputException; returns its path. Keywords are 1 to 79 printable ASCII characters. */
    public static Path write(Path target, Overwrite overwrite, BufferedImage image, Map<String, String> text) {
        return AtomicFile.write(target, overwrite, stream -> write(stream, image, text));
    }

    /** Writes to a stream, which stays open. */
    public static void write(OutputStream stream, BufferedImage image, Map<String, String> text) throws IOException {
        write(stream, image, text, 0);
    }

    /** Writes also the resolution (pHYs), unless it is 0. */
    public static void write(OutputStream stream, BufferedImage image, Map<String, String> text, double pixelsPerMeter)
            throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try (MemoryCacheImageOutputStream output = new MemoryCacheImageOutputStream(stream)) {
            IIOMetadata metadata = writer.getDefaultImageMetadata(
                    ImageTypeSpecifier.createFromRenderedImage(image), writer.getDefaultWriteParam());
            Map<String, String> all = new LinkedHashMap<>(Map.of("Software", "Sunbeam " + Environment.version()));
            all.putAll(text);
            IIOMetadataNode root = chunks(all);
            if (pixelsPerMeter > 0) {
                Map<String, String> physical = new HashMap<>(Map.of("unitSpecifier", "meter"));
                for (String side : List.of("pixelsPerUnitXAxis", "pixelsPerUnitYAxis")) {
                    physical.put(side, Long.toString(Math.round(pixelsPerMeter)));
                }
                add(root, "pHYs", physical);
            }
            metadata.mergeTree(NATIVE_FORMAT, root);
            writer.setOutput(output);
            writer.write(new IIOImage(image, null, metadata));
        } finally {
            writer.dispose();
        }
    }

    private static IIOMetadataNode chunks(Map<String, String> text) {
        IIOMetadataNode root = new IIOMetadataNode(NATIVE_FORMAT);
        add(root, "sRGB", Map.of("renderingIntent", "Perceptual"));
        IIOMetadataNode latin = new IIOMetadataNode("tEXt");
        IIOMetadataNode international = new IIOMetadataNode("iTXt");
        text.forEach((keyword, value) -> {
            if (StandardCharsets.ISO_8859_1.newEncoder().canEncode(value)) {
                add(latin, "tEXtEntry", Map.of("keyword", keyword, "value", value));
            } else {
                Map<String, String> entry = new HashMap<>(Map.of("keyword", keyword, "text", value));
                entry.putAll(Map.of("compressionFlag", "FALSE", "compressionMethod", "0"));
                entry.putAll(Map.of("languageTag", "", "translatedKeyword", ""));
                add(international, "iTXtEntry", entry);
            }
        });
        for (IIOMetadataNode entries : List.of(latin, international)) {
            if (entries.hasChildNodes()) {
                root.appendChild(entries);
            }
        }
        return root;
    }

    private static void add(IIOMetadataNode chunk, String name, Map<String, String> attributes) {
        IIOMetadataNode entry = new IIOMetadataNode(name);
        attributes.forEach(entry::setAttribute);
        chunk.appendChild(entry);
    }
}
