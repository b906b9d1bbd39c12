package sunbeam.app.viewer.input;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.app.viewer.model.Drags;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.pick.SkinPoint;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.app.viewer.window.Player;
import sunbeam.app.viewer.window.ScenePresenter;
import sunbeam.app.viewer.window.Viewer;

/** Mouse listener that applies the {@link MouseAction}s to the scene. */
public final class MouseControls extends MouseAdapter {
    private static final double ZOOM_STEP = 1.1;

    private final PictureView view;
    private final ViewerModel model;
    private final ScenePresenter presenter;
    private final Player player;
    private Point last;
    private Optional<SkinPoint> held = Optional.empty();
    private int presses;

    private MouseControls(Viewer viewer) {
        view = viewer.window().picture();
        model = viewer.model();
        presenter = viewer.presenter();
        player = viewer.player();
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
        if (last != null) {
            act(event);
        }
        last = event.getPoint();
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
            view.hideHint();
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
        player.stop();
        orient(scene -> Drags.turned(scene.view().camera(), scene.orientation(), right(event), up(event)));
    }

    void roll(MouseEvent event) {
        player.stop();
        double angle = angle(event.getPoint()) - angle(last);
        orient(scene -> Drags.rolled(scene.view().camera(), scene.orientation(), angle));
    }

    private void orient(Function<Scene, Quaternionfc> orientation) {
        model.change(scene -> {
            Scene turned = scene.withOrientation(orientation.apply(scene));
            return held.map(point -> following(point, turned)).orElse(turned);
        });
    }

    /** Moves the camera of a turned scene so that the grabbed point stays at its pixel. */
    private static Scene following(SkinPoint grabbed, Scene turned) {
        Vector3f shift = grabbed.in(turned).pick().position().sub(grabbed.pick().position(), new Vector3f());
        return turned.withView(Drags.shifted(grabbed.scene().view(), shift));
    }

    void moveLight(MouseEvent event) {
        double right = right(event);
        double up = up(event);
        model.change(scene -> scene.withLight(scene.light()
                .pointing(Drags.light(scene.view().camera(), scene.light().towards(), right, up))));
    }

    /** Returns the angle of the last move to the right; the view's shorter side is half a turn. */
    private double right(MouseEvent event) {
        return (event.getX() - last.x) * Math.PI / Math.min(view.getWidth(), view.getHeight());
    }

    private double up(MouseEvent event) {
        return (last.y - event.getY()) * Math.PI / Math.min(view.getWidth(), view.getHeight());
    }

    /** Returns a point's angle around the picture's center, counterclockwise, radians. */
    private double angle(Point point) {
        return Math.atan2(0.5 * view.getHeight() - point.y, point.x - 0.5 * view.getWidth());
    }
}
