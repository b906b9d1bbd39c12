package sunbeam.app.files.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.jfree.chart.text.G2TextMeasurer;
import org.jfree.chart.text.TextBlock;
import org.jfree.chart.text.TextBlockAnchor;
import org.jfree.chart.text.TextUtils;
import org.jfree.chart.ui.HorizontalAlignment;

/** White page of a report, filled from top to bottom with headings, paragraphs broken into lines, and rows of pictures. */
public final class Sheet {
    public static final Font FONT = PlotStyle.LABEL_FONT;

    private static final int MARGIN = 32;
    private static final int GAP = 14;
    // Least width of a plot beside another, pixels: 54 mm.
    private static final int NARROWEST = 640;

    /** Most thumbnails of a page; ten rows are as high as a screen or two. */
    public static final int MOST_THUMBNAILS = 60;

    // Thumbnails are for the screen: their text is smaller.
    private static final Font SMALL = PlotFont.plain(16);
    private static final int COLUMNS = 6;
    private static final int CELL = 300;
    private static final int CELL_GAP = 16;
    private static final int LARGEST_HEIGHT = 260;
    private static final Color FAILURE = new Color(0xB00020);
    // Text is anti-aliased and letters begin at whole pixels, as in pictures.
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, false);

    private final int width;
    private final List<Part> parts = new ArrayList<>();

    private record Part(int height, Consumer<Graphics2D> drawing) {}

    /** A small picture above its name and a sentence; without a picture, the sentence says why. */
    public record Thumbnail(Optional<BufferedImage> picture, String name, String sentence) {
        public static BufferedImage reduced(BufferedImage picture) {
            double across = (CELL - CELL_GAP) / (double) picture.getWidth();
            double scale = Math.min(1, Math.min(across, LARGEST_HEIGHT / (double) picture.getHeight()));
            int width = (int) Math.max(1, scale * picture.getWidth());
            int height = (int) Math.max(1, scale * picture.getHeight());
            BufferedImage reduced = picture;
            // Bilinear halves are exact means of 2 x 2 pixels, and six times as fast as area averaging.
            while (reduced.getWidth() > width || reduced.getHeight() > height) {
                reduced = scaled(
                        reduced, Math.max(width, reduced.getWidth() / 2), Math.max(height, reduced.getHeight() / 2));
            }
            return reduced;
        }

        private static BufferedImage scaled(BufferedImage picture, int width, int height) {
            BufferedImage scaled = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = scaled.createGraphics();
            graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            graphics.drawImage(picture, 0, 0, width, height, null);
            graphics.dispose();
            return scaled;
        }
    }

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

    /** Adds a line whose first word, if blanks follow that align it in a terminal, stands before the others' column. */
    public Sheet labeled(String line, int column) {
        String[] parts = line.split(" {2,}", 2);
        String label = parts.length > 1 ? parts[0] : "";
        TextBlock block = block(parts[parts.length - 1], FONT, width - 2 * MARGIN - column);
        return part(height(block) + GAP, graphics -> {
            draw(block(label, FONT, column), graphics, MARGIN, GAP);
            draw(block, graphics, MARGIN + column, GAP);
        });
    }

    /** Returns the width of each of two plots: half of the page, or all of a narrow one, where a row puts them one below the other. */
    public int plotWidth() {
        return width / 2 < NARROWEST ? width : width / 2;
    }

    public Sheet row(Drawing... drawings) {
        int across = Arrays.stream(drawings).mapToInt(Drawing::width).sum();
        List<Drawing> rows = across <= width ? List.of(Drawing.row(0, drawings)) : List.of(drawings);
        rows.forEach(row -> part(row.height(), graphics -> row.drawAt(graphics, 0, 0)));
        return this;
    }

    /** Adds a part that the caller draws, in ink and {@link #FONT}, with lines of 2 pixels and the origin at its upper left corner; the height is in pixels. */
    public Sheet part(int height, Consumer<Graphics2D> drawing) {
        parts.add(new Part(height, drawing));
        return this;
    }

    public int height() {
        return parts.stream().mapToInt(Part::height).sum();
    }

    public Drawing draw() {
        return new Drawing(width, height() + GAP, graphics -> {
            int y = 0;
            for (Part part : parts) {
                graphics.setColor(PlotStyle.INK);
                graphics.setFont(FONT);
                graphics.setStroke(PlotStyle.OUTLINE_STROKE);
                new Drawing(width, part.height, part.drawing).drawAt(graphics, 0, y);
                y += part.height;
            }
        });
    }

    static TextBlock block(String text, Font font, int width) {
        Graphics2D measuring = measuring(font);
        TextBlock block = TextUtils.createTextBlock(
                PlotStyle.typeset(text),
                PlotFont.with(font, text),
                PlotStyle.INK,
                width,
                Integer.MAX_VALUE,
                new G2TextMeasurer(measuring));
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
        Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        Drawing.smooth(graphics);
        graphics.setFont(font);
        return graphics;
    }

    public static BufferedImage ofThumbnails(String title, List<Thumbnail> thumbnails) {
        Sheet sheet = new Sheet(CELL_GAP + COLUMNS * CELL).heading(title);
        for (int first = 0; first < thumbnails.size(); first += COLUMNS) {
            sheet.thumbnailRow(thumbnails.subList(first, Math.min(thumbnails.size(), first + COLUMNS)));
        }
        return sheet.draw().rasterize();
    }

    private void thumbnailRow(List<Thumbnail> cells) {
        int pictures = cells.stream()
                .mapToInt(cell -> cell.picture().map(BufferedImage::getHeight).orElse(0))
                .max()
                .orElseThrow();
        List<TextBlock> sentences = cells.stream()
                .map(cell -> block(cell.sentence(), SMALL, CELL - CELL_GAP))
                .toList();
        int text = sentences.stream().mapToInt(Sheet::height).max().orElseThrow();
        int line = SMALL.getSize() + CELL_GAP / 2;
        part(CELL_GAP + pictures + line + text, graphics -> {
            for (int i = 0; i < cells.size(); i++) {
                int x = CELL_GAP + i * CELL;
                Thumbnail cell = cells.get(i);
                graphics.setColor(cell.picture().isPresent() ? PlotStyle.INK : FAILURE);
                cell.picture().ifPresent(picture -> graphics.drawImage(picture, x, CELL_GAP, null));
                graphics.setFont(PlotFont.bold(SMALL.getSize()));
                graphics.setFont(PlotFont.with(graphics.getFont(), cell.name()));
                String name = fittedName(cell.name(), graphics.getFont(), CELL - CELL_GAP);
                graphics.drawString(name, x, CELL_GAP + pictures + line - 4);
                draw(sentences.get(i), graphics, x, CELL_GAP + pictures + line);
            }
        });
    }

    /** Abbreviates names to a width in pixels; different names stay different, if need be by numbers. */
    public static List<String> fittedNames(List<String> names, Font font, double widest) {
        List<String> fitted = new ArrayList<>();
        Set<String> taken = new HashSet<>(names);
        for (String name : names) {
            String shown = fittedName(name, font, widest);
            for (int number = 2; !shown.equals(name) && taken.contains(shown); number++) {
                String ending = " #" + number;
                shown = fittedName(name, font, widest - width(ending, font)) + ending;
            }
            taken.add(shown);
            fitted.add(shown);
        }
        return fitted;
    }

    /** Abbreviates a name; two thirds of the letters that stay are from its beginning. */
    public static String fittedName(String name, Font font, double widest) {
        int[] letters = name.codePoints().toArray();
        String shown = name;
        for (int kept = letters.length - 1; kept > 1 && width(shown, font) > widest; kept--) {
            int first = (2 * kept + 2) / 3;
            String beginning = new String(letters, 0, first).stripTrailing();
            String end = new String(letters, letters.length - kept + first, kept - first).stripLeading();
            shown = beginning + "\u2026" + end;
        }
        return shown;
    }

    private static double width(String text, Font font) {
        return font.getStringBounds(text, CONTEXT).getWidth();
    }
}
