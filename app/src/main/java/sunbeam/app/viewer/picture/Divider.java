package sunbeam.app.viewer.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;

/** The same view by another method: what is seen to the right of a line across the picture. Belongs to the event thread. */
public final class Divider {
    private static final int REACH = 6;
    private static final int MARGIN = 8;
    private static final Color DARK = new Color(0, 0, 0, 170);

    private final Runnable repaint;
    private boolean isShown;
    private boolean isFinal;
    private BufferedImage picture;
    private String own = "";
    private String other = "";
    private double share = 0.5;
    private boolean isWhole;
    private boolean isGrabbed;

    /** @param repaint what it lies over */
    Divider(Runnable repaint) {
        this.repaint = repaint;
    }

    /**
     * Shows two methods.
     *
     * @param image by the other; null while there is none
     * @param complete whether it is what {@code render} writes
     */
    public void show(BufferedImage image, String ownWords, String otherWords, boolean complete) {
        isShown = true;
        isFinal = complete;
        picture = image;
        own = ownWords;
        other = otherWords;
        repaint.run();
    }

    /** Lays a part over the other picture. */
    public void showTile(BufferedImage tile, int x, int y, String otherWords) {
        if (picture != null) {
            Graphics2D graphics = picture.createGraphics();
            graphics.drawImage(tile, x, y, null);
            graphics.dispose();
            show(picture, own, otherWords, false);
        }
    }

    /** Leaves the picture as it is. */
    public void hide() {
        if (isShown) {
            isShown = false;
            isFinal = false;
            picture = null;
            repaint.run();
        }
    }

    public boolean isShown() {
        return isShown;
    }

    /** Whether that is what {@code render} writes. */
    public boolean isFinal() {
        return isFinal;
    }

    /** Shows the other in all of the picture, or on its side again. */
    public void whole(boolean value) {
        if (value != isWhole) {
            isWhole = value;
            repaint.run();
        }
    }

    /** Moves it to a share of the picture's width from the left, cut to 0 to 1. */
    public void move(double to) {
        share = Math.max(0, Math.min(1, to));
        repaint.run();
    }

    public double share() {
        return share;
    }

    /** Whether it is at a column, so that a hand can take hold of it. */
    public boolean isAt(int x, int width) {
        return isShown && Math.abs(x - share * width) <= REACH;
    }

    public void grab(boolean value) {
        isGrabbed = value;
    }

    public boolean isGrabbed() {
        return isGrabbed;
    }

    void paint(Graphics2D graphics, int width, int height) {
        if (!isShown) {
            return;
        }
        int x = isWhole ? 0 : (int) Math.round(share * width);
        if (picture != null) {
            Graphics2D right = (Graphics2D) graphics.create();
            right.clipRect(x, 0, width - x, height);
            right.drawImage(picture, 0, 0, width, height, null);
            right.dispose();
        }
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        if (!isWhole) {
            graphics.setColor(DARK);
            graphics.fillRect(x - 1, 0, 3, height);
            graphics.setColor(Color.WHITE);
            graphics.fillRect(x, 0, 1, height);
            graphics.fillRect(x - 2, height / 2 - 2 * REACH, 5, 4 * REACH);
            label(graphics, own, x - 2 * MARGIN - graphics.getFontMetrics().stringWidth(own));
        }
        label(graphics, other, x + 2 * MARGIN);
    }

    private static void label(Graphics2D graphics, String text, int x) {
        var metrics = graphics.getFontMetrics();
        graphics.setColor(DARK);
        graphics.fillRect(x - MARGIN, MARGIN, metrics.stringWidth(text) + 2 * MARGIN, metrics.getHeight() + 4);
        graphics.setColor(Color.WHITE);
        graphics.drawString(text, x, MARGIN + 2 + metrics.getAscent());
    }
}
