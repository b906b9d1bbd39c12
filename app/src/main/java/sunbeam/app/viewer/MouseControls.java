package sunbeam.app.viewer;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;
import jrtr.scene.Camera;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;

/** What the mouse does to the scene. */
final class MouseControls extends MouseAdapter {
    private static final double ZOOM_STEP = 1.1;

    private final PictureView view;
    private final ViewerModel model;
    private final Picking picking;
    private Point last;

    /** A double click, in the picture's pixels. */
    @FunctionalInterface
    interface Picking {
        void pick(int x, int y);
    }

    private MouseControls(PictureView view, ViewerModel model, Picking picking) {
        this.view = view;
        this.model = model;
        this.picking = picking;
    }

    static void install(PictureView view, ViewerModel model, Picking picking) {
        MouseControls controls = new MouseControls(view, model, picking);
        view.addMouseListener(controls);
        view.addMouseMotionListener(controls);
        view.addMouseWheelListener(controls);
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        last = event.getPoint();
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (SwingUtilities.isLeftMouseButton(event) && event.getClickCount() == 2) {
            double scale = view.pixelScale();
            picking.pick((int) (event.getX() * scale), (int) (event.getY() * scale));
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (last == null || view.getWidth() < 1 || view.getHeight() < 1) {
            return;
        }
        Point from = last;
        Point to = event.getPoint();
        last = to;
        boolean left = SwingUtilities.isLeftMouseButton(event);
        if (SwingUtilities.isRightMouseButton(event) || (left && event.isShiftDown())) {
            model.change(scene -> moveLight(scene, from, to));
        } else if (left) {
            model.change(scene -> turn(scene, from, to));
        } else if (SwingUtilities.isMiddleMouseButton(event)) {
            int width = view.getWidth();
            int height = view.getHeight();
            double right = (double) (to.x - from.x) / height;
            double up = (double) (from.y - to.y) / height;
            model.change(scene -> scene.withView(Drags.panned(scene.view(), right, up, width, height)));
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double factor = Math.pow(ZOOM_STEP, event.getPreciseWheelRotation());
        model.change(scene -> scene.withView(Drags.zoomed(scene.view(), factor)));
    }

    private Scene turn(Scene scene, Point from, Point to) {
        Camera camera = scene.view().camera();
        var turn = Drags.turn(camera, ballX(from), ballY(from), ballX(to), ballY(to));
        return scene.withOrientation(Drags.turned(scene.orientation(), turn));
    }

    private Scene moveLight(Scene scene, Point from, Point to) {
        double perPixel = Math.PI / Math.min(view.getWidth(), view.getHeight());
        var towards = Drags.light(
                scene.view().camera(), scene.light().towards(), (to.x - from.x) * perPixel, (from.y - to.y) * perPixel);
        return scene.withLight(new SceneLight(towards, scene.light().intensity()));
    }

    private double ballX(Point point) {
        return (2.0 * point.x - view.getWidth()) / Math.min(view.getWidth(), view.getHeight());
    }

    private double ballY(Point point) {
        return (view.getHeight() - 2.0 * point.y) / Math.min(view.getWidth(), view.getHeight());
    }
}
