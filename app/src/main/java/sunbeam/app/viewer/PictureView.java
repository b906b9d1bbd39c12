package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import sunbeam.app.render.LightCone;

/** Component that shows the newest picture, or the reason for having none. */
public final class PictureView extends JComponent {
    /** Overlay of outdated pictures. */
    public static final Color VEIL = new Color(0, 0, 0, 160);

    private static final int MARGIN = 24;
    private static final String HINT_SEPARATOR = "  \u00b7  ";
    private static final String HINT =
            String.join(HINT_SEPARATOR, "drag: turn", "right drag, or hold L: light", "wheel: zoom", "F1: all keys");

    private final JLabel message = new JLabel("Loading ...", SwingConstants.CENTER);
    private BufferedImage picture;
    // Enlarged while painting; {@link #whole} makes a full-size copy on demand.
    private transient Optional<Reduced> reduced = Optional.empty();
    private boolean isDimmed;
    private transient Optional<LightCone> cone = Optional.empty();
    private transient Optional<BufferedImage> strokes = Optional.empty();
    private transient List<Optional<Point>> marks = List.of();
    boolean isHintShown = true;
    /** True while the light follows the mouse without a button. */
    boolean isLightHeld;

    public final transient Divider divider = new Divider(this::repaint);
    final transient LightHandle light = new LightHandle(this::repaint);

    public PictureView() {
        setLayout(new BorderLayout());
        setOpaque(true);
        setBackground(new Color(0x101418));
        setPreferredSize(new Dimension(800, 600));
        message.setForeground(new Color(0xc8d0d8));
        message.setBorder(BorderFactory.createEmptyBorder(0, MARGIN, 0, MARGIN));
        add(message);
        setName("picture");
    }

    public void hideHint() {
        if (isHintShown) {
            isHintShown = false;
            repaint();
        }
    }

    /** In screen pixels; 0 if the component has no width. */
    public int pictureWidth() {
        return (int) Math.round(getWidth() * pixelScale());
    }

    public int pictureHeight() {
        return (int) Math.round(getHeight() * pixelScale());
    }

    /** In screen pixels per unit of Swing. */
    public double pixelScale() {
        return getGraphicsConfiguration() == null
                ? 1
                : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    /**
     * Picture with fewer pixels than the displayed width and height.
     *
     * @param padded picture with its edge pixels duplicated, since X servers blend the edge with the outside when they enlarge
     */
    private record Reduced(BufferedImage padded, int width, int height) {
        /** @param image image of type {@link BufferedImage#TYPE_INT_RGB} */
        static Reduced of(BufferedImage image, int width, int height) {
            int columns = image.getWidth();
            int rows = image.getHeight();
            BufferedImage padded = new BufferedImage(columns + 2, rows + 2, BufferedImage.TYPE_INT_RGB);
            int[] row = new int[columns + 2];
            for (int y = 0; y < rows + 2; y++) {
                image.getRaster().getDataElements(0, Math.max(0, Math.min(rows - 1, y - 1)), columns, 1, row);
                System.arraycopy(row, 0, row, 1, columns);
                row[columns + 1] = row[columns];
                padded.getRaster().setDataElements(0, y, columns + 2, 1, row);
            }
            return new Reduced(padded, width, height);
        }

        void paint(Graphics2D graphics, int across, int down) {
            double x = (double) across / (padded.getWidth() - 2);
            double y = (double) down / (padded.getHeight() - 2);
            Graphics2D inside = (Graphics2D) graphics.create(0, 0, across, down);
            inside.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            inside.drawImage(padded, new AffineTransform(x, 0, 0, y, -x, -y), null);
            inside.dispose();
        }
    }

    public void showMessage(String text) {
        String escaped = text.replace("&", "&amp;").replace("<", "&lt;");
        message.setText("<html><div style='text-align:center'>" + escaped + "</div></html>");
        message.setVisible(true);
        picture = null;
        reduced = Optional.empty();
        repaint();
    }

    /** Shows a picture; an image of fewer than width times height pixels is enlarged. */
    public void showPicture(BufferedImage image, int width, int height) {
        message.setVisible(false);
        boolean isWhole = image.getWidth() == width && image.getHeight() == height;
        picture = isWhole ? image : null;
        reduced = isWhole ? Optional.empty() : Optional.of(Reduced.of(image, width, height));
        repaint();
    }

    private BufferedImage whole() {
        if (picture == null && reduced.isPresent()) {
            Reduced shown = reduced.get();
            picture = new BufferedImage(shown.width, shown.height, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = picture.createGraphics();
            shown.paint(graphics, shown.width, shown.height);
            graphics.dispose();
        }
        return picture;
    }

    public void showTile(BufferedImage tile, int x, int y) {
        whole().getRaster().setDataElements(x, y, tile.getRaster());
        reduced = Optional.empty();
        repaint();
    }

    /** Without overlays; empty before the first. The image is read-only and valid until the next picture. */
    public Optional<BufferedImage> picture() {
        return Optional.ofNullable(whole());
    }

    /** Returns the displayed color of a pixel as 0xRRGGBB; empty before the first picture and outside the picture. */
    public OptionalInt color(int x, int y) {
        BufferedImage whole = whole();
        if (whole == null || x < 0 || y < 0 || x >= whole.getWidth() || y >= whole.getHeight()) {
            return OptionalInt.empty();
        }
        return OptionalInt.of(0xffffff & whole.getRGB(x, y));
    }

    public void dim(boolean old) {
        if (old != isDimmed) {
            isDimmed = old;
            repaint();
        }
    }

    /** Shows strokes, an image with transparent background, over the picture; empty removes them. */
    public void showStrokes(Optional<BufferedImage> value) {
        if (value.isPresent() || strokes.isPresent()) {
            strokes = value;
            repaint();
        }
    }

    public void showCone(Optional<LightCone> value) {
        if (value.equals(cone)) {
            return; // the next picture repaints it
        }
        // Repaint the cone at each event of a drag, without waiting for the next picture.
        Stream.concat(cone.stream(), value.stream()).forEach(shown -> repaint(shown.bounds(getWidth(), getHeight())));
        cone = value;
    }

    public void mark(List<Optional<Point>> pixels) {
        if (!pixels.equals(marks)) {
            marks = pixels;
            repaint();
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        if (picture == null && reduced.isEmpty()) {
            graphics.setColor(getBackground());
            graphics.fillRect(0, 0, getWidth(), getHeight());
        } else {
            Graphics2D scaled = (Graphics2D) graphics.create();
            reduced.ifPresentOrElse(
                    shown -> shown.paint(scaled, getWidth(), getHeight()),
                    () -> scaled.drawImage(picture, 0, 0, getWidth(), getHeight(), null));
            divider.paint(scaled, getWidth(), getHeight());
            strokes.ifPresent(image -> scaled.drawImage(image, 0, 0, getWidth(), getHeight(), null));
            if (isDimmed) {
                scaled.setColor(VEIL);
                scaled.fillRect(0, 0, getWidth(), getHeight());
            }
            scaled.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            scaled.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            for (int i = 0; i < marks.size(); i++) {
                int number = i;
                marks.get(i)
                        .ifPresent(pixel -> MapView.paintRing(
                                scaled, number, (pixel.x + 0.5) / pixelScale(), (pixel.y + 0.5) / pixelScale()));
            }
            if (isHintShown) {
                paintHint(scaled);
            }
            scaled.dispose();
            cone.ifPresent(shown -> shown.paint((Graphics2D) graphics.create(), getWidth(), getHeight()));
            light.paint((Graphics2D) graphics.create(), getWidth(), getHeight());
        }
    }

    /** In a narrow view, each part has a line. */
    private void paintHint(Graphics2D graphics) {
        FontMetrics metrics = graphics.getFontMetrics();
        boolean isWide = metrics.stringWidth(HINT) + 2 * MARGIN <= getWidth();
        String[] lines = isWide ? new String[] {HINT} : HINT.split(HINT_SEPARATOR, -1);
        for (int i = 0; i < lines.length; i++) {
            int y = getHeight() - 2 * MARGIN - (lines.length - 1 - i) * (metrics.getHeight() + 4);
            Divider.label(graphics, lines[i], (getWidth() - metrics.stringWidth(lines[i])) / 2, y);
        }
    }
}
