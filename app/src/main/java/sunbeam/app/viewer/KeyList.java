package sunbeam.app.viewer;

import java.awt.Component;
import java.awt.Font;
import javax.swing.JLabel;
import javax.swing.JOptionPane;

/** What the mouse and the keys do, for F1. */
final class KeyList {
    private static final String[][] LINES = {
        {"Left drag", "turn the model"},
        {"Right drag, Shift + left drag", "move the light"},
        {"Middle drag", "pan"},
        {"Wheel, + and -", "zoom"},
        {"Double click", "pick a point of the skin"},
        {"Arrow keys", "move the light by 2 degrees"},
        {"L", "show or hide the light's cone"},
        {"M", "show or hide the BRDF map"},
        {"Home", "back to the scene as it was loaded"},
        {"Ctrl+O", "load a scene"},
        {"Ctrl+S", "save the scene"},
        {"Ctrl+L", "load a patch (or drop its file on the window)"},
        {"Ctrl+P", "save the final picture"},
        {"Ctrl+Q", "quit"},
        {"F1", "this list"},
    };

    private KeyList() {}

    static void show(Component owner) {
        StringBuilder text = new StringBuilder("<html><table cellpadding='2'>");
        for (String[] line : LINES) {
            text.append("<tr><td><b>")
                    .append(line[0])
                    .append("</b>&nbsp;&nbsp;</td><td>")
                    .append(line[1])
                    .append("</td></tr>");
        }
        JLabel label = new JLabel(text.append("</table></html>").toString());
        label.setFont(label.getFont().deriveFont(Font.PLAIN));
        JOptionPane.showMessageDialog(owner, label, "Mouse and keys", JOptionPane.PLAIN_MESSAGE);
    }
}
