package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.Image;
import java.awt.RadialGradientPaint;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSeparator;
import javax.swing.ScrollPaneConstants;
import javax.swing.Scrollable;
import sunbeam.app.viewer.model.ViewerModel;

/** Window with its components and their layout. {@link Viewer} connects their behavior. */
public final class ViewerWindow extends JFrame {
    // Narrowest window, in Swing units, that opens with its panel beside the picture.
    private static final int NARROW = 900;

    private static final Color[] ICON_COLORS = IntStream.of(
                    0xfff4d0, 0x101418, 0x101418, 0x5030d0, 0x20a0ff, 0x30d060, 0xffe030, 0xff4020, 0x101418)
            .mapToObj(Color::new)
            .toArray(Color[]::new);
    private static final float[] ICON_RADII = {0, 0.2f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1};

    final StatusLine status = new StatusLine();
    final ControlPanel controls;
    final PictureView picture = new PictureView();
    final MapView map = new MapView();
    final PickPanel pick = new PickPanel();
    final JComponent panel;
    // True until the user shows or hides the panel.
    private boolean panelFollowsWidth = true;

    ViewerWindow(String title, ViewerModel model) {
        super(title);
        controls = new ControlPanel(model, status);
        Box below = Box.createVerticalBox();
        below.setBorder(BorderFactory.createEmptyBorder(8, 12, 8, 12));
        below.add(map);
        below.add(pick);
        JPanel lower = new JPanel(new BorderLayout());
        lower.add(new JSeparator(), BorderLayout.NORTH);
        lower.add(below);
        JPanel side = new SidePanel();
        side.setLayout(new BorderLayout());
        side.add(controls, BorderLayout.NORTH);
        side.add(lower);
        panel = new JScrollPane(
                side, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        panel.setBorder(BorderFactory.createEmptyBorder());
        panel.setPreferredSize(new Dimension(330, 100));
        // The message covers the picture's bottom, so that the picture keeps its size.
        picture.add(status.message, BorderLayout.SOUTH);
        add(picture);
        add(panel, BorderLayout.EAST);
        add(status, BorderLayout.SOUTH);
        setMinimumSize(new Dimension(60, 60));
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        setIconImages(Stream.of(16, 24, 32, 48, 64, 128).map(ViewerWindow::icon).toList());
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(1180, screen.width), Math.min(880, screen.height));
        // Under window managers that place windows themselves Java may not learn where: menus would open elsewhere.
        setLocationRelativeTo(null);
        panel.setVisible(getWidth() >= NARROW);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                if (panelFollowsWidth) {
                    panel.setVisible(getWidth() >= NARROW);
                    validate();
                }
            }
        });
    }

    /** Paints the icon: a spectrum around a light in the lower left corner. */
    private static Image icon(int side) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setPaint(new RadialGradientPaint(0, side, 1.1f * side, ICON_RADII, ICON_COLORS));
        graphics.fillRoundRect(0, 0, side, side, side / 4, side / 4);
        graphics.dispose();
        return image;
    }

    void fitPicture(Dimension size) {
        picture.setPreferredSize(size);
        panel.setVisible(size.width + panel.getPreferredSize().width >= NARROW);
        pack();
        setLocationRelativeTo(null);
    }

    public void showPanel(boolean shown) {
        panelFollowsWidth = false;
        panel.setVisible(shown);
        validate();
    }

    public void toggleFullScreen() {
        getGraphicsConfiguration().getDevice().setFullScreenWindow(isFullScreen() ? null : this);
    }

    public boolean isFullScreen() {
        return equals(getGraphicsConfiguration().getDevice().getFullScreenWindow());
    }

    /** Panel beside the picture that scrolls vertically if it needs more height, never horizontally. */
    private static final class SidePanel extends JPanel implements Scrollable {
        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
            return 16;
        }

        @Override
        public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
            return visible.height;
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return getParent().getHeight() >= getMinimumSize().height;
        }
    }
}
