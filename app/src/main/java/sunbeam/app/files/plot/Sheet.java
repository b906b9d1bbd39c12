package sunbeam.app.files.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jfree.chart.text.G2TextMeasurer;
import org.jfree.chart.text.TextBlock;
import org.jfree.chart.text.TextBlockAnchor;
import org.jfree.chart.text.TextUtils;
import org.jfree.chart.ui.HorizontalAlignment;

/** White page of a report, which is filled from top to bottom with headings, paragraphs broken into lines, and rows of pictures. */
public final class Sheet {
    public static final Color INK = PlotStyle.INK;
    public static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
    /** Font of fixed width for columns of values. */
    public static final Font TABLE_FONT = new Font(Font.MONOSPACED, Font.PLAIN, 15);

    private static final int MARGIN = 24;
    private static final int GAP = 8;

    private final int width;
    private final List<Part> parts = new ArrayList<>();

    private record Part(int height, Consumer<Graphics2D> drawing) {}

    public Sheet(int width) {
        this.width = width;
    }

    public Sheet heading(String text) {
        return text(text, PlotStyle.TITLE_FONT);
    }

    public Sheet text(String text, Font font) {
        TextBlock block = block(text, font, width - 2 * MARGIN);
        return part(height(block) + GAP, graphics -> draw(block, graphics, MARGIN, GAP));
    }

    /** Adds pictures side by side, their tops aligned. */
    public Sheet row(BufferedImage... pictures) {
        int height = List.of(pictures).stream()
                .mapToInt(BufferedImage::getHeight)
                .max()
                .orElseThrow();
        return part(height, graphics -> {
            int x = 0;
            for (BufferedImage picture : pictures) {
                graphics.drawImage(picture, x, 0, null);
                x += picture.getWidth();
            }
        });
    }

    /**
     * Adds a part that is drawn by the caller, in ink and {@link #FONT}.
     *
     * @param height height of the part in pixels
     * @param drawing function that draws the part, with the origin at the part's upper left corner
     */
    public Sheet part(int height, Consumer<Graphics2D> drawing) {
        parts.add(new Part(height, drawing));
        return this;
    }

    /** Returns the height of the parts so far in pixels. */
    public int height() {
        return parts.stream().mapToInt(Part::height).sum();
    }

    public BufferedImage draw() {
        BufferedImage page = new BufferedImage(width, height() + GAP, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = smooth(page);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, width, page.getHeight());
        for (Part part : parts) {
            graphics.setColor(INK);
            graphics.setFont(FONT);
            part.drawing.accept(graphics);
            graphics.translate(0, part.height);
        }
        graphics.dispose();
        return page;
    }

    /** Returns the graphics of a picture, with smooth letters and edges. */
    static Graphics2D smooth(BufferedImage picture) {
        Graphics2D graphics = picture.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        return graphics;
    }

    static TextBlock block(String text, Font font, int width) {
        Graphics2D measuring = measuring(font);
        TextBlock block =
                TextUtils.createTextBlock(text, font, INK, width, Integer.MAX_VALUE, new G2TextMeasurer(measuring));
        block.setLineAlignment(HorizontalAlignment.LEFT);
        measuring.dispose();
        return block;
    }

    static int height(TextBlock block) {
        Graphics2D measuring = measuring(FONT);
        int height = (int) Math.ceil(block.calculateDimensions(measuring).getHeight());
        measuring.dispose();
        return height;
    }

    static void draw(TextBlock block, Graphics2D graphics, int x, int y) {
        block.draw(graphics, x, y, TextBlockAnchor.TOP_LEFT);
    }

    private static Graphics2D measuring(Font font) {
        Graphics2D graphics = smooth(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB));
        graphics.setFont(font);
        return graphics;
    }
}
