package sunbeam.app.viewer;

import java.awt.Component;
import java.io.File;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;

/** A choice of names, to which files may be added; shows of a file its name alone, and does not grow with it. */
final class FileBox extends JComboBox<String> {
    private static final String USUAL_LENGTH = "xenopeltis-like";

    FileBox(String... names) {
        super(names);
        setPrototypeDisplayValue(USUAL_LENGTH);
        setRenderer(new ShortName());
    }

    private static final class ShortName extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            String path = String.valueOf(value);
            Component shown =
                    super.getListCellRendererComponent(list, new File(path).getName(), index, selected, focused);
            setToolTipText(path);
            return shown;
        }
    }
}
