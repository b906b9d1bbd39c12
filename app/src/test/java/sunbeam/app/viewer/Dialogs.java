package sunbeam.app.viewer;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

final class Dialogs {
    private Dialogs() {}

    /** Waits for a dialog whose title begins with {@code title}. */
    static JDialog await(String title) throws Exception {
        ViewerInAWindow.awaitOnEvents(() -> showing(title).isPresent());
        return ViewerInAWindow.onEvents(() -> showing(title).orElseThrow());
    }

    static void choose(String title, Path file) throws Exception {
        JDialog dialog = await(title);
        // Do not wait: approving may open the viewer's next dialog.
        SwingUtilities.invokeLater(() -> {
            JFileChooser chooser = all(dialog, JFileChooser.class).get(0);
            chooser.setSelectedFile(file.toFile());
            chooser.approveSelection();
        });
    }

    static void answer(String title, String button) throws Exception {
        JDialog dialog = await(title);
        SwingUtilities.invokeLater(
                () -> find(dialog, AbstractButton.class, candidate -> button.equals(candidate.getText()))
                        .doClick());
        ViewerInAWindow.awaitOnEvents(() -> !dialog.isShowing());
    }

    static void type(String title, String... texts) throws Exception {
        JDialog dialog = await(title);
        ViewerInAWindow.onEvents(() -> {
            List<JTextField> fields = all(dialog, JTextField.class);
            for (int i = 0; i < texts.length; i++) {
                fields.get(i).setText(texts[i]);
            }
        });
    }

    private static Optional<JDialog> showing(String title) {
        for (Window window : Window.getWindows()) {
            if (window instanceof JDialog dialog
                    && dialog.isShowing()
                    && dialog.getTitle().startsWith(title)) {
                return Optional.of(dialog);
            }
        }
        return Optional.empty();
    }

    /** Returns the first component of a type, at any depth, that a condition holds for. */
    static <T> T find(Container root, Class<T> type, Predicate<T> condition) {
        return all(root, type).stream().filter(condition).findFirst().orElseThrow();
    }

    static <T> List<T> all(Container root, Class<T> type) {
        List<T> found = new ArrayList<>();
        for (Component child : root.getComponents()) {
            if (type.isInstance(child)) {
                found.add(type.cast(child));
            }
            if (child instanceof Container inner) {
                found.addAll(all(inner, type));
            }
        }
        return found;
    }
}
