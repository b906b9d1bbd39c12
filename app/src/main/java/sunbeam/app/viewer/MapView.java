package sunbeam.app.viewer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.text.Text;

/** BRDF map for the light's direction, with marks at the picked points' view directions. */
public final class MapView extends JComponent {
    static final int CAPTION = 18;
    private static final int BESIDE = 14;
    private static final Color AXES = new Color(255, 255, 255, 50);

    private BufferedImage map;
    private transient Optional<Direction> marked = Optional.empty();
    private transient List<GratingOrders> orders = List.of();
    private String caption = "";
    private String ordersInWords;
    boolean isNewest;
    private boolean isCoarse;

    public MapView() {
        setMinimumSize(new Dimension(60, 60 + CAPTION));
        setPreferredSize(new Dimension(240, 196 + CAPTION));
        setMaximumSize(new Dimension(Short.MAX_VALUE, 280 + CAPTION));
        setAlignmentX(LEFT_ALIGNMENT);
        setName("map");
        orders(List.of(), "");
    }

    /** Marks orders; the words are for the tooltip: the gratings' period, or why no orders are marked. */
    public void orders(List<GratingOrders> value, String words) {
        if (value.equals(orders) && words.equals(ordersInWords)) {
            return;
        }
        orders = value;
        ordersInWords = words;
        setToolTipText(
                "<html><body style='width: 260px'>BRDF map: the color towards each direction; x and y of unit vectors along tangent"
                        + " and bitangent, no unit; circles at 30 and 60 degrees to the normal. The ring marks the picked pixel's direction to the"
                        + " viewer; dots are the grating equation's orders at 450, 550 and 650 nm. " + words);
        repaint();
    }

    /** Shows a map; {@code coarse} if it is from a coarse level of the color tables, as its caption then says. */
    public void show(BufferedImage image, boolean coarse) {
        map = image;
        isCoarse = coarse;
        repaint();
    }

    /** Sets whether the final map of the newest light is shown; another is dimmed, unless it is coarse, and its caption says so. */
    public void newest(boolean value) {
        if (value != isNewest) {
            isNewest = value;
            repaint();
        }
    }

    /** Marks the direction to the viewer, tangent frame, and sets the caption. */
    public void mark(Optional<Direction> direction, String text) {
        if (!direction.equals(marked) || !text.equals(caption)) {
            marked = direction;
            caption = text;
            repaint();
        }
    }

    /** Removes the map; the caption is the reason. */
    public void clear(String text) {
        map = null;
        newest(true);
        mark(Optional.empty(), text);
        repaint();
    }

    @Override
    protected void paintComponent(Graphics plain) {
        Graphics2D graphics = (Graphics2D) plain.create();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        int side = Math.max(1, Math.min(getWidth() - 2 * BESIDE, getHeight() - CAPTION));
        int left = (getWidth() - side) / 2;
        Ellipse2D disc = new Ellipse2D.Double(left, 0, side, side);
        graphics.setColor(Color.BLACK);
        graphics.fill(disc);
        if (map != null) {
            // Intersect with the existing clip: a scroll pane may show a part of the map.
            Graphics2D clipped = (Graphics2D) graphics.create();
            clipped.clip(disc);
            clipped.drawImage(map, left, 0, side, side, null);
            if (!isNewest && !isCoarse) {
                clipped.setColor(PictureView.VEIL);
                clipped.fill(disc);
            }
            clipped.dispose();
            graphics.setFont(graphics.getFont().deriveFont(10f));
            Labels labels = new Labels(graphics, new Rectangle(getWidth(), side));
            paintAxes(graphics, labels, left, side);
            for (int i = 0; i < orders.size(); i++) {
                orders.get(i).paint(graphics, labels, i == 0, left, side);
            }
            marked.filter(to -> to.z() > 0)
                    .ifPresent(
                            to -> paintRing(graphics, 0, left + 0.5 * side * (1 + to.x()), 0.5 * side * (1 - to.y())));
        }
        graphics.setColor(getForeground());
        graphics.setFont(getFont().deriveFont(11f));
        String text = isNewest
                ? caption
                : map != null && isCoarse ? "BRDF map: coarse, being refined" : "BRDF map: being made";
        int width = graphics.getFontMetrics().stringWidth(text);
        graphics.drawString(text, Math.max(0, (getWidth() - width) / 2), side + CAPTION - 5);
        graphics.dispose();
    }

    /** Paints axes and circles of a map with this left edge and diameter; later labels do not lie on the axes. */
    static void paintAxes(Graphics2D graphics, Labels labels, int left, int side) {
        double middle = left + 0.5 * side;
        graphics.setStroke(new BasicStroke(1f));
        graphics.setColor(AXES);
        graphics.draw(new Line2D.Double(left, 0.5 * side, left + side, 0.5 * side));
        graphics.draw(new Line2D.Double(middle, 0, middle, side));
        labels.avoid(new Rectangle2D.Double(left, 0.5 * side - 1, side, 2));
        labels.avoid(new Rectangle2D.Double(middle - 1, 0, 2, side));
        labels.paint("x", left + side, 0.5 * side);
        labels.paint("y", middle, 12);
        for (int theta = 30; theta < 90; theta += 30) {
            graphics.setColor(AXES);
            double radius = 0.5 * side * Math.sin(Math.toRadians(theta));
            graphics.draw(new Ellipse2D.Double(middle - radius, 0.5 * side - radius, 2 * radius, 2 * radius));
            labels.paint(theta + "°", middle - 0.5 * radius, 0.5 * side + 0.87 * radius);
        }
    }

    static void paintRing(Graphics2D graphics, int number, double x, double y) {
        Ellipse2D ring = new Ellipse2D.Double(x - 6, y - 6, 12, 12);
        graphics.setStroke(new BasicStroke(3f));
        graphics.setColor(Color.BLACK);
        graphics.draw(ring);
        float[] dashes = number == 0 ? null : new float[] {4, 3};
        graphics.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0));
        graphics.setColor(Color.WHITE);
        graphics.draw(ring);
    }

    /** Small labels of one painting: each lies within the bounds and covers no other. A label that finds no free place is left out. */
    static final class Labels {
        private static final double GAP = 4;

        private final Graphics2D graphics;
        private final Rectangle2D bounds;
        private final List<Rectangle2D> taken = new ArrayList<>();

        Labels(Graphics2D graphics, Rectangle2D bounds) {
            this.graphics = graphics;
            this.bounds = bounds;
        }

        /** Keeps labels out of a place, such as an axis. */
        void avoid(Rectangle2D place) {
            taken.add(place);
        }

        /** Paints a label beside a point: to the upper right, else upper left, lower right or lower left. Returns its place, or null. */
        Rectangle2D paint(String text, double x, double y) {
            FontMetrics metrics = graphics.getFontMetrics();
            double width = metrics.stringWidth(text) + 1.0;
            double height = metrics.getAscent();
            for (double top : new double[] {y - GAP - height + 2, y + GAP}) {
                for (double left : new double[] {x + GAP, x - GAP - width}) {
                    Rectangle2D place = new Rectangle2D.Double(left, top, width, height);
                    if (bounds.contains(place) && taken.stream().noneMatch(place::intersects)) {
                        taken.add(place);
                        paintOutlined(text, (float) left, (float) (top + height - 1));
                        return place;
                    }
                }
            }
            return null;
        }

        private void paintOutlined(String text, float x, float y) {
            graphics.setColor(Color.BLACK);
            graphics.drawString(text, x + 1, y + 1);
            graphics.setColor(Color.WHITE);
            graphics.drawString(text, x, y);
        }
    }

    /**
     * Directions of a grating's orders by the grating equation: (u, v) is order times wavelength times the grating's spatial frequency.
     *
     * @param wave spatial frequency of the heights, in cycles per meter of the tangent frame, which the light's direction has, too
     */
    public record GratingOrders(SpatialFrequency wave, Direction light) {
        /** Marked wavelengths in meters: blue, green, red. */
        public static final List<Double> WAVELENGTHS = List.of(450e-9, 550e-9, 650e-9);

        private static final double GREEN = WAVELENGTHS.get(1);
        // Smallest distance of neighboring marks in pixels; orders are skipped, since closer marks would hide the map.
        private static final double CLOSEST = 12;
        private static final List<Color> COLORS =
                List.of(new Color(0x5080ff), new Color(0x30d030), new Color(0xff4030));

        /** Returns an order's direction as (x, y) of a unit vector, for a wavelength in meters; empty if it is below the horizon. */
        public Optional<Point2D> direction(int order, double wavelength) {
            double x = -light.x() - order * wavelength * wave.x();
            double y = -light.y() - order * wavelength * wave.y();
            return x * x + y * y < 1 ? Optional.of(new Point2D.Double(x, y)) : Optional.empty();
        }

        /** Paints marks on the BRDF map, a disc with this left edge and diameter in pixels; order 0 is the same for all gratings. */
        void paint(Graphics2D graphics, Labels labels, boolean withMirror, double left, double side) {
            double apart = 0.5 * side * GREEN * wave.length();
            int step = (int) Math.max(1, Math.ceil(CLOSEST / apart));
            int last = (int) Math.floor(2 / (WAVELENGTHS.get(0) * wave.length()));
            // Low orders come first, since a label that would cover another is left out.
            for (int order = 0; order <= last; order += step) {
                if (order > 0 || withMirror) {
                    paint(graphics, labels, order, left, side);
                }
                if (order > 0) {
                    paint(graphics, labels, -order, left, side);
                }
            }
        }

        private void paint(Graphics2D graphics, Labels labels, int order, double left, double side) {
            Optional<Point2D> previous = Optional.empty();
            for (int i = 0; i < WAVELENGTHS.size(); i++) {
                Optional<Point2D> at = direction(order, WAVELENGTHS.get(i))
                        .map(found -> new Point2D.Double(
                                left + 0.5 * side * (1 + found.getX()), 0.5 * side * (1 - found.getY())));
                if (at.isEmpty()) {
                    return;
                }
                if (previous.isPresent()) {
                    graphics.setColor(Color.GRAY);
                    graphics.setStroke(new BasicStroke(1f));
                    graphics.draw(new Line2D.Double(previous.get(), at.get()));
                    paintDot(graphics, order == 0 ? Color.WHITE : COLORS.get(i - 1), previous.get());
                }
                paintDot(graphics, order == 0 ? Color.WHITE : COLORS.get(i), at.get());
                if (WAVELENGTHS.get(i) == GREEN) {
                    labels.paint(
                            order == 0 ? "0" : Text.format("%+d", order),
                            at.get().getX(),
                            at.get().getY());
                }
                previous = at;
            }
        }

        private static void paintDot(Graphics2D graphics, Color color, Point2D at) {
            Ellipse2D dot = new Ellipse2D.Double(at.getX() - 2.5, at.getY() - 2.5, 5, 5);
            graphics.setColor(color);
            graphics.fill(dot);
            graphics.setStroke(new BasicStroke(1f));
            graphics.setColor(Color.BLACK);
            graphics.draw(dot);
        }
    }
}
