package sunbeam.app.files.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.jfree.chart.text.TextBlock;

/** Page of small pictures in a grid, each above its name and a sentence. */
public final class ThumbnailSheet {
    /** Most pictures of a page; ten rows are as high as a screen or two. */
    public static final int MOST = 60;

    private static final int COLUMNS = 6;
    private static final int CELL = 300;
    private static final int GAP = 16;
    private static final int LARGEST_HEIGHT = 260;
    private static final Color FAILURE = new Color(0xB00020);

    public record Thumbnail(Optional<BufferedImage> picture, String name, String sentence) {
        /** Reduces a picture to the size of a thumbnail. */
        public static BufferedImage reduced(BufferedImage picture) {
            double scale = Math.min(
                    1,
                    Math.min(
                            (CELL - GAP) / (double) picture.getWidth(), LARGEST_HEIGHT / (double) picture.getHeight()));
            int width = (int) Math.max(1, scale * picture.getWidth());
            int height = (int) Math.max(1, scale * picture.getHeight());
            BufferedImage reduced = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = reduced.createGraphics();
            // Drawn at once: a scaled instance keeps the whole picture.
            graphics.drawImage(picture.getScaledInstance(width, height, Image.SCALE_AREA_AVERAGING), 0, 0, null);
            graphics.dispose();
            return reduced;
        }
    }

    private ThumbnailSheet() {}

    public static BufferedImage draw(String title, List<Thumbnail> thumbnails) {
        Sheet sheet = new Sheet(GAP + COLUMNS * CELL).heading(title);
        for (int first = 0; first < thumbnails.size(); first += COLUMNS) {
            row(sheet, thumbnails.subList(first, Math.min(thumbnails.size(), first + COLUMNS)));
        }
        return sheet.draw();
    }

    private static void row(Sheet sheet, List<Thumbnail> cells) {
        int pictures = cells.stream()
                .mapToInt(cell -> cell.picture().map(BufferedImage::getHeight).orElse(0))
                .max()
                .orElseThrow();
        List<TextBlock> sentences = cells.stream()
                .map(cell -> Sheet.block(cell.sentence(), Sheet.FONT, CELL - GAP))
                .toList();
        int text = sentences.stream().mapToInt(Sheet::height).max().orElseThrow();
        int line = Sheet.FONT.getSize() + GAP / 2;
        sheet.part(GAP + pictures + line + text, graphics -> {
            for (int i = 0; i < cells.size(); i++) {
                int x = GAP + i * CELL;
                Thumbnail cell = cells.get(i);
                graphics.setColor(cell.picture().isPresent() ? Sheet.INK : FAILURE);
                cell.picture().ifPresent(picture -> graphics.drawImage(picture, x, GAP, null));
                graphics.setFont(Sheet.FONT.deriveFont(Font.BOLD));
                graphics.drawString(
                        FittedNames.of(cell.name(), graphics.getFont(), CELL - GAP), x, GAP + pictures + line - 4);
                Sheet.draw(sentences.get(i), graphics, x, GAP + pictures + line);
            }
        });
    }
}
