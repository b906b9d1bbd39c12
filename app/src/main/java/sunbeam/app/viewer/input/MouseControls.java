package sunbeam.app.viewer.input;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.stream.Stream;
import jrtr.scene.Camera;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.viewer.model.Drags;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.pick.PickedPoint;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.app.viewer.window.ScenePresenter;
import sunbeam.app.viewer.window.Viewer;

/** Mouse listener that applies the {@link MouseAction}s to the scene. */
public final class MouseControls extends MouseAdapter {
    private static final double ZOOM_STEP = 1.1;

    private final PictureView view;
    private final ViewerModel model;
    private final ScenePresenter presenter;
    private Point last;
    // Point under the pointer when the button was pressed.
    private Optional<PickedPoint> held = Optional.empty();
    private int presses;

    private MouseControls(Viewer viewer) {
        view = viewer.window().picture();
        model = viewer.model();
        presenter = viewer.presenter();
    }

    public static void install(Viewer viewer) {
        MouseControls controls = new MouseControls(viewer);
        controls.view.addMouseListener(controls);
        controls.view.addMouseMotionListener(controls);
        controls.view.addMouseWheelListener(controls);
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        last = event.getPoint();
        view.divider().grab(isAtDivider(event));
        held = Optional.empty();
        int press = ++presses;
        Point pixel = pixel(event);
        presenter.locate(pixel.x, pixel.y, found -> held = press == presses ? found : held);
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        view.setCursor(Cursor.getPredefinedCursor(isAtDivider(event) ? Cursor.E_RESIZE_CURSOR : Cursor.DEFAULT_CURSOR));
    }

    private boolean isAtDivider(MouseEvent event) {
        return view.divider().isAt(event.getX(), view.getWidth());
    }

    void divide(MouseEvent event) {
        view.divider().move((double) event.getX() / view.getWidth());
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        act(event);
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        act(event);
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (last != null) {
            act(event);
            last = event.getPoint();
        }
    }

    private void act(MouseEvent event) {
        if (view.getWidth() > 0 && view.getHeight() > 0) {
            Stream.of(MouseAction.values())
                    .filter(action -> action.fits(event))
                    .findFirst()
                    .ifPresent(action -> action.run(this, event));
        }
    }

    private Point pixel(MouseEvent event) {
        double scale = view.pixelScale();
        return new Point((int) (event.getX() * scale), (int) (event.getY() * scale));
    }

    void pick(MouseEvent event) {
        Point pixel = pixel(event);
        presenter.pick(pixel.x, pixel.y);
    }

    void pickBeside(MouseEvent event) {
        Point pixel = pixel(event);
        presenter.pickBeside(pixel.x, pixel.y);
    }

    void zoom(MouseEvent event) {
        held = Optional.empty();
        double notches = ((MouseWheelEvent) event).getPreciseWheelRotation();
        int width = view.getWidth();
        int height = view.getHeight();
        double right = (event.getX() - 0.5 * width) / height;
        double up = 0.5 - (double) event.getY() / height;
        model.change(scene ->
                scene.withView(Drags.zoomed(scene.view(), Math.pow(ZOOM_STEP, notches), right, up, width, height)));
    }

    void pan(MouseEvent event) {
        int width = view.getWidth();
        int height = view.getHeight();
        double right = (double) (event.getX() - last.x) / height;
        double up = (double) (last.y - event.getY()) / height;
        model.change(scene -> scene.withView(Drags.panned(scene.view(), right, up, width, height)));
    }

    void turn(MouseEvent event) {
        Point to = event.getPoint();
        model.change(scene -> {
            Camera camera = scene.view().camera();
            var turn = Drags.turn(camera, ballX(last), ballY(last), ballX(to), ballY(to));
            Scene turned = scene.withOrientation(Drags.turned(scene.orientation(), turn));
            return held.map(point -> following(point, turned)).orElse(turned);
        });
    }

    /** Moves the camera of a turned scene so that the grabbed point stays at its pixel. */
    private static Scene following(PickedPoint grabbed, Scene turned) {
        Vector3f shift = grabbed.in(turned).pick().position().sub(grabbed.pick().position(), new Vector3f());
        return turned.withView(Drags.shifted(grabbed.scene().view(), shift));
    }

    void moveLight(MouseEvent event) {
        double perPixel = Math.PI / Math.min(view.getWidth(), view.getHeight());
        double right = (event.getX() - last.x) * perPixel;
        double up = (last.y - event.getY()) * perPixel;
        model.change(scene -> scene.withLight(new SceneLight(
                Drags.light(scene.view().camera(), scene.light().towards(), right, up),
                scene.light().intensity())));
    }

    private double ballX(Point point) {
        return (2.0 * point.x - view.getWidth()) / Math.min(view.getWidth(), view.getHeight());
    }

    private double ballY(Point point) {
        return (view.getHeight() - 2.0 * point.y) / Math.min(view.getWidth(), view.getHeight());
    }
}
