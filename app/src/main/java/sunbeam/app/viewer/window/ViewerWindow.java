package sunbeam.app.viewer.window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSeparator;
import javax.swing.ScrollPaneConstants;
import javax.swing.Scrollable;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.panel.ControlPanel;
import sunbeam.app.viewer.pick.PickPanel;
import sunbeam.app.viewer.picture.MapView;
import sunbeam.app.viewer.picture.PictureView;

/** The window and where its parts stand. What they do is {@link Viewer}'s business. */
public final class ViewerWindow extends JFrame {
    private final ControlPanel controls;
    private final PictureView picture = new PictureView();
    private final MapView map = new MapView();
    private final PickPanel pick = new PickPanel();
    private final StatusLine status = new StatusLine();
    private final JPanel mapPanel = new JPanel(new BorderLayout());

    ViewerWindow(String title, ViewerModel model) {
        super(title);
        controls = new ControlPanel(model, status::message);
        mapPanel.add(map);
        mapPanel.setBorder(BorderFactory.createEmptyBorder(8, 12, 0, 12));
        JPanel below = new JPanel(new BorderLayout());
        below.add(mapPanel, BorderLayout.NORTH);
        below.add(pick);
        JPanel side = new JPanel(new BorderLayout());
        side.add(controls, BorderLayout.NORTH);
        side.add(new JSeparator());
        side.add(below, BorderLayout.SOUTH);
        JPanel top = new AsWideAsItsView();
        top.add(side, BorderLayout.NORTH);
        JScrollPane scroll = new JScrollPane(
                top, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setPreferredSize(new Dimension(330, 100));
        add(picture);
        add(scroll, BorderLayout.EAST);
        add(status, BorderLayout.SOUTH);
        setMinimumSize(new Dimension(60, 60));
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        setSize(1180, 880);
        setLocationByPlatform(true);
    }

    public PictureView picture() {
        return picture;
    }

    public ControlPanel controls() {
        return controls;
    }

    MapView map() {
        return map;
    }

    public PickPanel pick() {
        return pick;
    }

    public StatusLine status() {
        return status;
    }

    void showMap(boolean shown) {
        mapPanel.setVisible(shown);
    }

    /** What is beside the picture is scrolled up and down, never sideways. */
    private static final class AsWideAsItsView extends JPanel implements Scrollable {
        private static final int UNIT = 16;

        private AsWideAsItsView() {
            super(new BorderLayout());
        }

        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
            return UNIT;
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
            return false;
        }
    }
}
