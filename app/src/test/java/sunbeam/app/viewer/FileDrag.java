package sunbeam.app.viewer;

import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DragSource;
import java.awt.dnd.DragSourceAdapter;
import java.awt.dnd.DragSourceDragEvent;
import java.awt.dnd.DragSourceDropEvent;
import java.awt.dnd.DragSourceEvent;
import java.awt.event.InputEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;

/** A window beside the viewer, as a file manager's, out of which a robot drags files through the windowing system. */
final class FileDrag implements AutoCloseable {
    private static final int LEFT = 900;
    private static final int SIDE = 120;

    private final Robot robot;
    private final JFrame window;
    private final AtomicReference<Boolean> over = new AtomicReference<>(false);
    private final AtomicReference<DragSourceDropEvent> end = new AtomicReference<>();

    /** Opens the window with one thing to drag. It offers to copy as well as to move it, as file managers do. */
    FileDrag(Robot robot, Path file) throws Exception {
        this.robot = robot;
        window = ViewerInAWindow.onEvents(() -> {
            JFrame frame = new JFrame("files");
            JLabel label = new JLabel(file.getFileName().toString());
            frame.add(label);
            frame.setBounds(LEFT, 0, SIDE, SIDE);
            DragSource.getDefaultDragSource()
                    .createDefaultDragGestureRecognizer(
                            label,
                            DnDConstants.ACTION_COPY_OR_MOVE,
                            gesture -> gesture.startDrag(null, new Files(file), new Watch()));
            frame.setVisible(true);
            return frame;
        });
    }

    /**
     * Drops the file on a component's middle.
     *
     * @return what the source is told at the end
     */
    DragSourceDropEvent dropOn(Component target) throws Exception {
        Point corner = ViewerInAWindow.onEvents(target::getLocationOnScreen);
        int x = corner.x + target.getWidth() / 2;
        int y = corner.y + target.getHeight() / 2;
        ViewerInAWindow.await(() -> ViewerInAWindow.onEvents(window::isShowing));
        robot.mouseMove(LEFT + SIDE / 2, SIDE / 2);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        for (int step = 1; step <= 10; step++) {
            robot.mouseMove(LEFT + SIDE / 2 - 3 * step, SIDE / 2);
        }
        // Again and again, as a hand does: the target answers to what moves over it.
        for (int nudge = 0; !over.get() && nudge < 1000; nudge++) {
            robot.mouseMove(x + nudge % 2, y);
        }
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        ViewerInAWindow.await(() -> end.get() != null);
        return end.get();
    }

    @Override
    public void close() {
        SwingUtilities.invokeLater(window::dispose);
    }

    private final class Watch extends DragSourceAdapter {
        @Override
        public void dragEnter(DragSourceDragEvent event) {
            over.set(true);
        }

        @Override
        public void dragExit(DragSourceEvent event) {
            over.set(false);
        }

        @Override
        public void dragDropEnd(DragSourceDropEvent event) {
            end.set(event);
        }
    }

    /** A list of one file. */
    private record Files(Path file) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return flavor.equals(DataFlavor.javaFileListFlavor);
        }

        @Override
        public List<File> getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
            if (!isDataFlavorSupported(flavor)) {
                throw new UnsupportedFlavorException(flavor);
            }
            return List.of(file.toFile());
        }
    }
}
