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
            "drag of the line between two methods",
            "moves it",
            event -> isDrag(event)
                    && event.getComponent() instanceof PictureView view
                    && view.divider().isGrabbed(),
            MouseControls::divide),
    LIGHT(
            "right drag, Shift + left drag",
            "moves the light",
            event -> isDrag(event)
                    && (SwingUtilities.isRightMouseButton(event)
                            || (SwingUtilities.isLeftMouseButton(event) && event.isShiftDown())),
            MouseControls::moveLight),
    PAN(
            "middle drag, Ctrl + left drag",
            "pans",
            event -> isDrag(event)
                    && (SwingUtilities.isMiddleMouseButton(event)
                            || (SwingUtilities.isLeftMouseButton(event) && event.isControlDown())),
            MouseControls::pan),
    TURN(
            "left drag",
            "turns the model about the point under the pointer",
            event -> isDrag(event) && SwingUtilities.isLeftMouseButton(event),
            MouseControls::turn),
    ZOOM("wheel", "zooms to the pointer", event -> event instanceof MouseWheelEvent, MouseControls::zoom),
    PICK_BESIDE(
            "Shift + double click on the skin",
            "picks a second point beside it",
            event -> isDoubleClick(event) && event.isShiftDown(),
            MouseControls::pickBeside),
    PICK("double click on the skin", "picks the point", MouseAction::isDoubleClick, MouseControls::pick);

    private final String gesture;
    private final String description;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final transient Predicate<MouseEvent> fits;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final transient BiConsumer<MouseControls, MouseEvent> effect;

    MouseAction(
            String gesture,
            String description,
            Predicate<MouseEvent> fits,
            BiConsumer<MouseControls, MouseEvent> effect) {
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

    String gesture() {
        return gesture;
    }

    String description() {
        return description;
    }

    boolean fits(MouseEvent event) {
        return fits.test(event);
    }

    void run(MouseControls controls, MouseEvent event) {
        effect.accept(controls, event);
    }
}
