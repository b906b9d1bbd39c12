package sunbeam.app.viewer;

import java.awt.Dimension;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;

/**
 * Row of the help window and of the table in docs/viewer.md.
 *
 * @param input gesture or keys
 */
record Help(Group group, String input, String description) {
    /** Group of mouse and key actions, in the order of the help. A group with a menu offers its key actions there. */
    enum Group {
        LIGHT("Turning and light", false),
        CAMERA("Camera", false),
        SKIN("Points and methods", false),
        FILE("File", true),
        EDIT("Edit", true),
        VIEW("View", true),
        HELP("Help", true);

        final String title;
        final boolean hasMenu;

        Group(String title, boolean hasMenu) {
            this.title = title;
            this.hasMenu = hasMenu;
        }
    }

    static List<Help> rows(Group group) {
        return Stream.concat(
                        Stream.of(MouseControls.Gesture.values()).map(gesture -> gesture.help),
                        Stream.of(Action.values()).map(action -> action.help))
                .filter(row -> row.group == group)
                .toList();
    }

    static void show(ViewerWindow window) {
        String rows = Stream.of(Group.values())
                .map(group -> rows(group).stream()
                        .map(row -> "<tr><td><b>" + row.input() + "</b>&nbsp;&nbsp;</td><td>" + row.description()
                                + "</td></tr>")
                        .collect(
                                Collectors.joining("", "<tr><td colspan='2'><u>" + group.title + "</u></td></tr>", "")))
                .collect(Collectors.joining("<tr><td>&nbsp;</td></tr>", "<html><table cellpadding='1'>", "</table>"));
        JScrollPane list = new JScrollPane(new JLabel(rows.replace("<td>", "<td style='font-weight:normal'>")));
        Dimension whole = list.getPreferredSize();
        list.setPreferredSize(new Dimension(
                Math.min(whole.width + 24, window.getWidth() - 80),
                Math.min(whole.height + 8, window.getHeight() - 120)));
        list.setBorder(null);
        JOptionPane.showMessageDialog(window, list, "Mouse and keys", JOptionPane.PLAIN_MESSAGE);
    }
}
