package sunbeam.app.viewer.panel;

import java.awt.Component;
import java.io.File;
import java.util.List;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;

/** Combo box of built-in names and files. Files are shown by their last path element; the box keeps its width. */
final class NameBox extends JComboBox<String> {
    /** @param names built-in names; file names are cut to about the width of the longest of these */
    NameBox(List<String> names) {
        names.forEach(this::addItem);
        names.stream()
                .reduce((one, other) -> one.length() < other.length() ? other : one)
                .ifPresent(this::setPrototypeDisplayValue);
        setRenderer(new LastPart());
    }

    void select(String name) {
        if (name.equals(getSelectedItem())) {
            return;
        }
        if (((DefaultComboBoxModel<String>) getModel()).getIndexOf(name) < 0) {
            addItem(name);
        }
        setSelectedItem(name);
    }

    private static final class LastPart extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object name, int index, boolean selected, boolean focused) {
            String path = name == null ? "" : name.toString();
            setToolTipText(path);
            return super.getListCellRendererComponent(list, new File(path).getName(), index, selected, focused);
        }
    }
}
