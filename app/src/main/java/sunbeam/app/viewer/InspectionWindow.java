package sunbeam.app.viewer;

import java.awt.Dimension;
import java.awt.Image;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BiFunction;
import javax.swing.ImageIcon;
import javax.swing.JDialog;
import javax.swing.JLabel;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.viewer.model.Background;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.patch.Patch;

/** Window with the picture that command {@code inspect} writes of a patch. Used on the event thread only. */
final class InspectionWindow {
    private static final double SHARE_OF_SCREEN = 0.85;

    private final Viewer viewer;
    private final Background drawing = new Background("inspection");
    private final JLabel picture = new JLabel();
    /** Draws an inspection; empty where the viewer was opened without one. */
    Optional<BiFunction<Patch, GratingPeriod, Drawing>> inspection = Optional.empty();
    // The patch before the one whose picture is to appear once its period is known; empty if none is to appear.
    private Optional<Patch> before = Optional.empty();
    private JDialog dialog;

    InspectionWindow(Viewer viewer) {
        this.viewer = viewer;
    }

    /** The picture of the patch that the user opens appears unasked. */
    void awaitPatch() {
        before = patch();
    }

    void cancel() {
        before = Optional.empty();
    }

    void showIfAwaited() {
        if (before.isPresent() && !before.equals(patch())) {
            show();
        }
    }

    private Optional<Patch> patch() {
        return viewer.model.loaded().map(loaded -> loaded.firstPart().patch());
    }

    /** Draws the loaded patch in the background, if its period is known, and shows it beside the viewer, which keeps the focus. */
    void show() {
        patch().ifPresent(patch -> viewer.periods.find(patch).ifPresent(period -> {
            cancel();
            inspection.ifPresent(drawer -> drawing.run(
                    () -> drawer.apply(patch, period).rasterize(),
                    image -> show(patch.name(), image),
                    viewer.window.status::message));
        }));
    }

    private void show(String name, BufferedImage image) {
        if (dialog == null) {
            dialog = new JDialog(viewer.window);
            dialog.setAutoRequestFocus(false);
            dialog.add(picture);
        }
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        double scale = Math.min(
                1,
                SHARE_OF_SCREEN
                        * Math.min(
                                (double) screen.width / image.getWidth(), (double) screen.height / image.getHeight()));
        picture.setIcon(new ImageIcon(
                image.getScaledInstance((int) (scale * image.getWidth()), -1, Image.SCALE_AREA_AVERAGING)));
        dialog.setTitle("Inspection of " + name);
        dialog.pack();
        dialog.setVisible(true);
    }

    void close() {
        drawing.close();
    }
}
