package sunbeam.app.viewer;

import java.awt.Component;
import java.awt.GridLayout;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;
import sunbeam.precompute.patch.PatchRequest;

/** From a file to a patch request: a descriptor speaks for itself, an image's scale is asked for. */
final class PatchScaleDialog {
    private PatchScaleDialog() {}

    /**
     * Asks where it must.
     *
     * @return nothing if the user thought better of it
     * @throws sunbeam.precompute.patch.PatchException if an answer is no length
     */
    static Optional<PatchRequest> request(Component owner, Path file) {
        String name = file.toAbsolutePath().toString();
        if (name.toLowerCase(Locale.ROOT).endsWith(".json")) {
            return Optional.of(PatchRequest.of(name));
        }
        JTextField width = new JTextField("65um", 10);
        JTextField height = new JTextField("375nm", 10);
        width.setToolTipText("Extent of the image along x, a length such as 65um");
        height.setToolTipText("Height of the image's full scale, a length such as 375nm");
        JPanel form = new JPanel(new GridLayout(2, 2, 8, 6));
        form.add(new JLabel("Width"));
        form.add(width);
        form.add(new JLabel("Height of full scale"));
        form.add(height);
        int answer = JOptionPane.showConfirmDialog(
                owner, form, "Scale of " + file.getFileName(), JOptionPane.OK_CANCEL_OPTION, JOptionPane.PLAIN_MESSAGE);
        return answer == JOptionPane.OK_OPTION
                ? Optional.of(PatchRequest.parse(name, width.getText(), null, height.getText(), null, null))
                : Optional.empty();
    }
}
