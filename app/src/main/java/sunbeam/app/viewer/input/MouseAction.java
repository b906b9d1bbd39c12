package sunbeam.app.viewer.input;

import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import javax.swing.SwingUtilities;
import sunbeam.app.viewer.picture.PictureView;

/**
 * Mouse actions over the picture; handling, help and docs/viewer.md derive from this enum. The first constant that matches an event handles
 * it.
 */
enum MouseAction {
    DIVIDE(
            Group.SKIN,
            "drag of the line between two methods",
            "moves it",
            event -> isDrag(event)
                    && event.getComponent() instanceof PictureView view
                    && view.divider().isGrabbed(),
            MouseControls::divide),
    TURN(
            Group.LIGHT,
            "left drag",
            "turns the model about the point under the pointer; what stands upright stays so",
            event -> isDrag(event)
                    && SwingUtilities.isLeftMouseButton(event)
                    && !event.isControlDown()
                    && !event.isShiftDown(),
            MouseControls::turn),
    ROLL(
            Group.LIGHT,
            "Ctrl + Shift + left drag",
            "rolls the model",
            event -> isDrag(event)
                    && SwingUtilities.isLeftMouseButton(event)
                    && event.isControlDown()
                    && event.isShiftDown(),
            MouseControls::roll),
    LIGHT(
            Group.LIGHT,
            "right drag, Shift + left drag",
            "moves the light",
            event -> (isDrag(event)
                            && (SwingUtilities.isRightMouseButton(event)
                                    || (SwingUtilities.isLeftMouseButton(event) && event.isShiftDown())))
                    || (event.getID() == MouseEvent.MOUSE_MOVED
                            && event.getComponent() instanceof PictureView view
                            && view.isLightHeld()),
            MouseControls::moveLight),
    PAN(
            Group.CAMERA,
            "middle drag, Ctrl + left drag",
            "pans",
            event -> isDrag(event)
                    && (SwingUtilities.isMiddleMouseButton(event)
                            || (SwingUtilities.isLeftMouseButton(event) && event.isControlDown())),
            MouseControls::pan),
    ZOOM(Group.CAMERA, "wheel", "zooms to the pointer", event -> event instanceof MouseWheelEvent, MouseControls::zoom),
    PICK_BESIDE(
            Group.SKIN,
            "Shift + double click on the skin",
            "picks a second point beside it",
            event -> isDoubleClick(event) && event.isShiftDown(),
            MouseControls::pickBeside),
    PICK(Group.SKIN, "double click on the skin", "picks the point", MouseAction::isDoubleClick, MouseControls::pick);

    private final Group group;
    private final String gesture;
    private final String description;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final transient Predicate<MouseEvent> fits;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final transient BiConsumer<MouseControls, MouseEvent> effect;

    MouseAction(
            Group group,
            String gesture,
            String description,
            Predicate<MouseEvent> fits,
            BiConsumer<MouseControls, MouseEvent> effect) {
        this.group = group;
        this.gesture = gesture;
        this.description = description;
        this.fits = fits;
        this.effect = effect;
    }

    private static boolean isDrag(MouseEvent event) {
        return event.getID() == MouseEvent.MOUSE_DRAGGED;
    }

    private static boolean isDoubleClick(MouseEvent event) {
        return event.getID() == MouseEvent.MOUSE_CLICKED
                && event.getClickCount() == 2
                && SwingUtilities.isLeftMouseButton(event);
    }

    Group group() {
        return group;
    }

    Help help() {
        return new Help(gesture, description);
    }

    boolean fits(MouseEvent event) {
        return fits.test(event);
    }

    void run(MouseControls controls, MouseEvent event) {
        effect.accept(controls, event);
    }
}
