package sunbeam.app.viewer;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;

/** Split view: the comparison method's picture to the right of a vertical line. Used on the event thread only. */
public final class Divider {
    // Farthest distance from the line, in Swing units, at which the mouse can grab it.
    private static final int REACH = 6;
    private static final int MARGIN = 8;
    private static final Color DARK = new Color(0, 0, 0, 170);

    private final Runnable repaint;
    private Comparison shown;
    private double share = 0.5;
    private boolean isWhole;

    /** @param picture picture by the comparison method; null before its first */
    private record Comparison(BufferedImage picture, String ownLabel, String otherLabel, boolean isFinal) {}

    Divider(Runnable repaint) {
        this.repaint = repaint;
    }

    /** Shows a picture by the comparison method, or none yet (null). */
    public void show(BufferedImage image, String ownLabel, String otherLabel, boolean isFinal) {
        show(new Comparison(image, ownLabel, otherLabel, isFinal));
    }

    private void show(Comparison value) {
        shown = value;
        repaint.run();
    }

    public void showTile(BufferedImage tile, int x, int y, String otherLabel) {
        if (shown != null && shown.picture != null) {
            shown.picture.getRaster().setDataElements(x, y, tile.getRaster());
            show(shown.picture, shown.ownLabel, otherLabel, false);
        }
    }

    public void hide() {
        if (shown != null) {
            show(null);
        }
    }

    public boolean isFinal() {
        return shown != null && shown.isFinal;
    }

    /** Sets whether the comparison method has the whole picture, or what is right of the line. */
    public void whole(boolean value) {
        if (value != isWhole) {
            isWhole = value;
            repaint.run();
        }
    }

    /** Moves the line to a share of the picture's width, clamped to [0, 1]. */
    public void move(double to) {
        share = Math.max(0, Math.min(1, to));
        repaint.run();
    }

    public double share() {
        return share;
    }

    public boolean isAt(int x, int width) {
        return shown != null && Math.abs(x - share * width) <= REACH;
    }

    void paint(Graphics2D graphics, int width, int height) {
        if (shown == null) {
            return;
        }
        int x = isWhole ? 0 : (int) Math.round(share * width);
        if (shown.picture != null) {
            Graphics2D right = (Graphics2D) graphics.create();
            right.clipRect(x, 0, width - x, height);
            right.drawImage(shown.picture, 0, 0, width, height, null);
            right.dispose();
        }
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        if (!isWhole) {
            graphics.setColor(DARK);
            graphics.fillRect(x - 1, 0, 3, height);
            graphics.setColor(Color.WHITE);
            graphics.fillRect(x, 0, 1, height);
            graphics.fillRect(x - 2, height / 2 - 2 * REACH, 5, 4 * REACH);
            label(
                    graphics,
                    shown.ownLabel,
                    x - 2 * MARGIN - graphics.getFontMetrics().stringWidth(shown.ownLabel),
                    MARGIN);
        }
        label(graphics, shown.otherLabel, x + 2 * MARGIN, MARGIN);
    }

    /** Paints a line of text on a dark strip whose top is at {@code y}. */
    static void label(Graphics2D graphics, String text, int x, int y) {
        var metrics = graphics.getFontMetrics();
        graphics.setColor(DARK);
        graphics.fillRect(x - MARGIN, y, metrics.stringWidth(text) + 2 * MARGIN, metrics.getHeight() + 4);
        graphics.setColor(Color.WHITE);
        graphics.drawString(text, x, y + 2 + metrics.getAscent());
    }
}
