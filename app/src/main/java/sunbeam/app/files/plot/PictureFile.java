package sunbeam.app.files.plot;

import java.nio.file.Path;
import java.util.Map;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;

/** Files of a drawing: a PNG bitmap, or vectors as PDF or SVG, whose bitmaps, such as a map of heights, stay bitmaps. */
public final class PictureFile {
    // Largest side of a page of PDF (ISO 32000, annex C), meters.
    private static final double LARGEST_PAGE = 200 * 0.0254;
    // Pixels of the largest bitmap: 800 MB of memory.
    private static final long MOST_PIXELS = 200_000_000;

    private PictureFile() {}

    /**
     * Refuses a size in pixels, with a printed width in meters.
     *
     * @throws UsageException if the picture is too high for a page or too large for a bitmap
     */
    public static void requireSize(Path file, int width, long height, double printedWidth) {
        double printedHeight = printedWidth * height / width;
        boolean bitmap = Ending.ofPicture(file).equals("png");
        UsageException.throwIf(
                bitmap ? width * height > MOST_PIXELS : printedHeight > LARGEST_PAGE,
                Text.format(
                        "%s would be %.1f m high, too much for %s; draw fewer surfaces or one --panel",
                        file, printedHeight, bitmap ? "a bitmap" : "a page"));
    }

    /**
     * Returns the content of a file in the format that its ending names.
     *
     * @param width printed width, meters
     * @param text entries by keyword, of 1 to 79 printable ASCII characters each
     * @throws UsageException if the picture is too high for a page or too large for a bitmap
     */
    public static StreamContent of(Path file, Drawing drawing, double width, Map<String, String> text) {
        requireSize(file, drawing.width(), drawing.height(), width);
        return switch (Ending.ofPicture(file)) {
            case "pdf" -> stream -> PdfFile.write(stream, drawing, width, text);
            case "svg" -> stream -> SvgFile.write(stream, drawing, width, text);
            default -> stream -> PngWriter.write(stream, drawing.rasterize(), text, drawing.width() / width);
        };
    }
}
