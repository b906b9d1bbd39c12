package sunbeam.app.viewer.panel;

import java.awt.Component;
import java.awt.GridLayout;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Turns a file into a patch request. Descriptors and scans contain their width and height scale; for an image, a dialog asks the user. */
public final class PatchScaleDialog {
    private PatchScaleDialog() {}

    /**
     * Returns the request for a file, after a dialog if the file has no scale.
     *
     * @return empty if the user canceled the dialog
     * @throws sunbeam.precompute.setting.SettingException if an entered length is invalid
     */
    public static Optional<PatchRequest> request(Component owner, Path file) {
        Choices named = Choices.at(ControlOrigin.INSTANCE)
                .with(PatchSettings.PATCH, file.toAbsolutePath().toString());
        if (file.toString().toLowerCase(Locale.ROOT).endsWith(".json") || PatchLoader.isScan(file)) {
            return Optional.of(new PatchRequest(named));
        }
        JPanel form = new JPanel(new GridLayout(2, 2, 8, 6));
        JTextField width = field(form, PatchSettings.WIDTH, "65um");
        JTextField maxHeight = field(form, PatchSettings.MAX_HEIGHT, "375nm");
        int answer = JOptionPane.showConfirmDialog(
                owner, form, "Scale of " + file.getFileName(), JOptionPane.OK_CANCEL_OPTION, JOptionPane.PLAIN_MESSAGE);
        return answer == JOptionPane.OK_OPTION
                ? Optional.of(
                        new PatchRequest(named.parsed(PatchSettings.WIDTH, width.getText(), ControlOrigin.INSTANCE)
                                .parsed(PatchSettings.MAX_HEIGHT, maxHeight.getText(), ControlOrigin.INSTANCE)))
                : Optional.empty();
    }

    private static JTextField field(JPanel form, Setting<Double> setting, String first) {
        JTextField field = new JTextField(first, 10);
        field.setToolTipText(ControlOrigin.INSTANCE.tip(setting, ""));
        form.add(new JLabel(ControlOrigin.INSTANCE.name(setting)));
        form.add(field);
        return field;
    }
}
