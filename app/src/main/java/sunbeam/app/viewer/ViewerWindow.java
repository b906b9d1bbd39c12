package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSeparator;
import javax.swing.ScrollPaneConstants;

/** The window and where its parts stand. What they do is {@link Viewer}'s business. */
final class ViewerWindow extends JFrame {
    private final ControlPanel controls;
    private final PictureView picture = new PictureView();
    private final MapView map = new MapView();
    private final PickPanel pick = new PickPanel();
    private final StatusLine status = new StatusLine();
    private final JPanel mapPanel = new JPanel(new BorderLayout());

    /** Puts the window together; it is not shown yet. */
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
        JPanel top = new JPanel(new BorderLayout());
        top.add(side, BorderLayout.NORTH);
        JScrollPane scroll = new JScrollPane(
                top, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setPreferredSize(new Dimension(310, 100));
        scroll.getVerticalScrollBar().setUnitIncrement(16);
        add(picture);
        add(scroll, BorderLayout.EAST);
        add(status, BorderLayout.SOUTH);
        setMinimumSize(new Dimension(60, 60));
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        setSize(1180, 820);
        setLocationByPlatform(true);
    }

    PictureView picture() {
        return picture;
    }

    ControlPanel controls() {
        return controls;
    }

    MapView map() {
        return map;
    }

    PickPanel pick() {
        return pick;
    }

    StatusLine status() {
        return status;
    }

    void showMap(boolean shown) {
        mapPanel.setVisible(shown);
    }
}
