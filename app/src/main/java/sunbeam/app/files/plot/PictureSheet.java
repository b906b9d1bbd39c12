package sunbeam.app.files.plot;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;

/** Several pictures as one, row by row. */
public final class PictureSheet {
    private static final int MOST_COLUMNS = 3;
    private static final int GAP = 8;

    private PictureSheet() {}

    /**
     * Lays pictures side by side, three in a row at most, their tops aligned; transparent between them. A single one stays
     * itself.
     *
     * @param pictures at least one
     */
    public static BufferedImage of(List<BufferedImage> pictures) {
        if (pictures.size() == 1) {
            return pictures.get(0);
        }
        int columns = Math.min(MOST_COLUMNS, pictures.size());
        int rows = (pictures.size() + columns - 1) / columns;
        int width = largest(pictures, true);
        int height = largest(pictures, false);
        BufferedImage sheet = new BufferedImage(
                columns * (width + GAP) - GAP, rows * (height + GAP) - GAP, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = sheet.createGraphics();
        for (int i = 0; i < pictures.size(); i++) {
            graphics.drawImage(pictures.get(i), i % columns * (width + GAP), i / columns * (height + GAP), null);
        }
        graphics.dispose();
        return sheet;
    }

    private static int largest(List<BufferedImage> pictures, boolean wide) {
        return pictures.stream()
                .mapToInt(picture -> wide ? picture.getWidth() : picture.getHeight())
                .max()
                .orElseThrow();
    }
}
