package sunbeam.app.viewer;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.joml.Vector3f;
import sunbeam.app.render.LightCone;
import sunbeam.app.scene.Scene;
import sunbeam.app.viewer.Action.Group;
import sunbeam.app.viewer.Action.Help;
import sunbeam.app.viewer.model.Drags;
import sunbeam.app.viewer.model.ViewerModel;

/** Mouse listener that applies the {@link Gesture}s to the scene. */
public final class MouseControls extends MouseAdapter {
    /** Mouse actions; handling, help and docs/viewer.md derive from this enum. The first constant that fits an event handles it. */
    @SuppressWarnings("ImmutableEnumChecker") // rows of texts, and lambdas without state
    enum Gesture {
        DIVIDE(
                new Help(Group.SKIN, "drag of the line between two methods", "moves it"),
                (controls, event) -> isDrag(event) && controls.isDividerGrabbed,
                (controls, event) -> controls.view.divider.move((double) event.getX() / controls.view.getWidth())),
        SUN(
                new Help(Group.LIGHT, "drag of the sun", "moves the light to the pointer"),
                (controls, event) -> isDrag(event) && controls.isSunGrabbed,
                MouseControls::moveSun),
        TURN(
                new Help(
                        Group.LIGHT,
                        "left drag",
                        "turns the model about the point under the pointer; what stands upright stays so"),
                (controls, event) -> isLeftDrag(event, 0),
                (controls, event) ->
                        controls.orient(scene -> Drags.turned(scene, controls.right(event), controls.up(event)))),
        ROLL(
                new Help(Group.LIGHT, "Ctrl + Shift + left drag", "rolls the model"),
                (controls, event) -> isLeftDrag(event, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK),
                MouseControls::roll),
        LIGHT(
                new Help(Group.LIGHT, "right drag, Shift + left drag", "moves the light"),
                (controls, event) -> (isDrag(event) && SwingUtilities.isRightMouseButton(event))
                        || isLeftDrag(event, InputEvent.SHIFT_DOWN_MASK)
                        || (event.getID() == MouseEvent.MOUSE_MOVED && controls.view.isLightHeld),
                (controls, event) ->
                        controls.model.change(scene -> Drags.lit(scene, controls.right(event), controls.up(event)))),
        PAN(
                new Help(Group.CAMERA, "middle drag, Ctrl + left drag", "pans"),
                (controls, event) -> (isDrag(event) && SwingUtilities.isMiddleMouseButton(event))
                        || isLeftDrag(event, InputEvent.CTRL_DOWN_MASK),
                MouseControls::pan),
        ZOOM(
                new Help(Group.CAMERA, "wheel", "zooms to the pointer"),
                (controls, event) -> event instanceof MouseWheelEvent,
                MouseControls::zoom),
        PICK_BESIDE(
                new Help(Group.SKIN, "Shift + double click on the skin", "picks a second point beside it"),
                (controls, event) -> isDoubleClick(event) && event.isShiftDown(),
                MouseControls::pick),
        PICK(
                new Help(Group.SKIN, "double click or long press on the skin", "picks the point, and its object"),
                (controls, event) -> isDoubleClick(event),
                MouseControls::pick);

        final Help help;
        private final transient BiPredicate<MouseControls, MouseEvent> fits;
        private final transient BiConsumer<MouseControls, MouseEvent> effect;

        Gesture(Help help, BiPredicate<MouseControls, MouseEvent> fits, BiConsumer<MouseControls, MouseEvent> effect) {
            this.help = help;
            this.fits = fits;
            this.effect = effect;
        }

        private static boolean isDrag(MouseEvent event) {
            return event.getID() == MouseEvent.MOUSE_DRAGGED;
        }

        /** @param keys masks of the keys that are held, of Ctrl and Shift */
        private static boolean isLeftDrag(MouseEvent event, int keys) {
            int held = event.getModifiersEx() & (InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
            return isDrag(event) && SwingUtilities.isLeftMouseButton(event) && held == keys;
        }

        private static boolean isDoubleClick(MouseEvent event) {
            return event.getID() == MouseEvent.MOUSE_CLICKED
                    && event.getClickCount() == 2
                    && SwingUtilities.isLeftMouseButton(event);
        }
    }

    private static final double ZOOM_STEP = 1.1;
    private static final int LONG_PRESS_MILLISECONDS = 600;
    // A finger that rests moves less, in Swing units.
    private static final int REST = 8;

    private final Viewer viewer;
    private final PictureView view;
    private final ViewerModel model;
    private Point last;
    private Optional<SkinPoint> held = Optional.empty();
    private boolean isDividerGrabbed;
    private boolean isSunGrabbed;
    private int presses;
    private MouseEvent pressed;
    private final Timer longPress = new Timer(LONG_PRESS_MILLISECONDS, event -> pick(pressed));

    private MouseControls(Viewer viewer) {
        this.viewer = viewer;
        view = viewer.window.picture;
        model = viewer.model;
        longPress.setRepeats(false);
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
        isDividerGrabbed = isAtDivider(event);
        view.light.touch();
        isSunGrabbed = !isDividerGrabbed
                && event.getModifiersEx() == InputEvent.BUTTON1_DOWN_MASK
                && view.light.isAt(event.getX(), event.getY(), view.getWidth(), view.getHeight());
        pressed = event;
        longPress.stop();
        if (event.getModifiersEx() == InputEvent.BUTTON1_DOWN_MASK && !isSunGrabbed && !isDividerGrabbed) {
            longPress.start();
        }
        held = Optional.empty();
        int press = ++presses;
        Point pixel = pixel(event);
        viewer.inspector.locate(pixel.x, pixel.y, found -> held = press == presses ? found : held);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        longPress.stop();
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        view.light.touch();
        if (last != null) {
            act(event);
        }
        last = event.getPoint();
        view.setCursor(Cursor.getPredefinedCursor(isAtDivider(event) ? Cursor.E_RESIZE_CURSOR : Cursor.DEFAULT_CURSOR));
    }

    private boolean isAtDivider(MouseEvent event) {
        return view.divider.isAt(event.getX(), view.getWidth());
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
            view.light.touch();
            if (pressed == null || event.getPoint().distance(pressed.getPoint()) > REST) {
                longPress.stop();
            }
            act(event);
            last = event.getPoint();
        }
    }

    private void act(MouseEvent event) {
        if (view.getWidth() > 0 && view.getHeight() > 0) {
            Stream.of(Gesture.values())
                    .filter(gesture -> gesture.fits.test(this, event))
                    .findFirst()
                    .ifPresent(gesture -> gesture.effect.accept(this, event));
        }
    }

    private Point pixel(MouseEvent event) {
        double scale = view.pixelScale();
        return new Point((int) (event.getX() * scale), (int) (event.getY() * scale));
    }

    private void pick(MouseEvent event) {
        Point pixel = pixel(event);
        viewer.inspector.pick(pixel.x, pixel.y, event.isShiftDown());
    }

    private void moveSun(MouseEvent event) {
        double length = LightCone.LENGTH * Math.min(view.getWidth(), view.getHeight());
        double right = (event.getX() - 0.5 * view.getWidth()) / length;
        double up = (0.5 * view.getHeight() - event.getY()) / length;
        model.change(scene -> Drags.litAt(scene, right, up));
    }

    private void zoom(MouseEvent event) {
        held = Optional.empty();
        double factor = Math.pow(ZOOM_STEP, ((MouseWheelEvent) event).getPreciseWheelRotation());
        int width = view.getWidth();
        int height = view.getHeight();
        double right = (event.getX() - 0.5 * width) / height;
        double up = 0.5 - (double) event.getY() / height;
        model.change(scene -> Drags.zoomed(scene, factor, right, up, width, height));
    }

    private void pan(MouseEvent event) {
        double right = (double) (event.getX() - last.x) / view.getHeight();
        double up = (double) (last.y - event.getY()) / view.getHeight();
        model.change(scene -> Drags.panned(scene, right, up, view.getWidth(), view.getHeight()));
    }

    private void roll(MouseEvent event) {
        double angle = angle(event.getPoint()) - angle(last);
        orient(scene -> Drags.rolled(scene, angle));
    }

    /** Applies a change of orientation and moves the camera so that the grabbed point stays at its pixel. */
    private void orient(UnaryOperator<Scene> change) {
        viewer.player.stop();
        model.change(scene -> {
            Scene turned = change.apply(scene);
            if (held.isEmpty()) {
                return turned;
            }
            SkinPoint point = held.get();
            Vector3f moved = new Vector3f(point.in(turned).pick().position());
            return Drags.shifted(
                    turned.withView(point.scene().view()),
                    moved.sub(point.pick().position()),
                    1);
        });
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
