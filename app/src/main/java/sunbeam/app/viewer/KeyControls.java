package sunbeam.app.viewer;

import java.awt.Font;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import sunbeam.app.scene.SceneLight;

/** Menus, and what the keys do. */
final class KeyControls {
    private static final double STEP = Math.toRadians(2);
    private static final double ZOOM = 1.1;

    private static final String[][] HELP = {
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

    private final Viewer viewer;
    private final ViewerModel model;
    private final FileActions files;

    KeyControls(Viewer viewer, ViewerModel model, FileActions files) {
        this.viewer = viewer;
        this.model = model;
        this.files = files;
    }

    JMenuBar menus() {
        JMenuBar bar = new Menus();
        bar.add(menu("File", fileItems()));
        bar.add(menu("View", viewItems()));
        bar.add(menu("Help", Map.of("Mouse and keys\tF1", this::showHelp)));
        return bar;
    }

    private void showHelp() {
        StringBuilder text = new StringBuilder("<html><table cellpadding='2'>");
        for (String[] line : HELP) {
            text.append("<tr><td><b>")
                    .append(line[0])
                    .append("</b>&nbsp;&nbsp;</td><td>")
                    .append(line[1])
                    .append("</td></tr>");
        }
        JLabel label = new JLabel(text.append("</table></html>").toString());
        label.setFont(label.getFont().deriveFont(Font.PLAIN));
        JOptionPane.showMessageDialog(viewer.window(), label, "Mouse and keys", JOptionPane.PLAIN_MESSAGE);
    }

    private Map<String, Runnable> fileItems() {
        Map<String, Runnable> items = new LinkedHashMap<>();
        items.put("Load scene or mesh ...\tctrl O", files::loadScene);
        items.put("Save scene ...\tctrl S", files::saveScene);
        items.put("Load patch ...\tctrl L", files::loadPatch);
        items.put("Save picture ...\tctrl P", files::savePicture);
        items.put("Quit\tctrl Q", viewer::quit);
        return items;
    }

    private Map<String, Runnable> viewItems() {
        Map<String, Runnable> items = new LinkedHashMap<>();
        items.put("Light's cone\tL", viewer.presenter()::toggleCone);
        items.put("BRDF map\tM", viewer.presenter()::toggleMap);
        items.put("As loaded\tHOME", viewer::reset);
        return items;
    }

    private static JMenu menu(String name, Map<String, Runnable> items) {
        JMenu menu = new JMenu(name);
        items.forEach((text, action) -> {
            String[] parts = text.split("\t", -1);
            JMenuItem item = new JMenuItem(parts[0]);
            item.setAccelerator(KeyStroke.getKeyStroke(parts[1]));
            item.addActionListener(event -> action.run());
            menu.add(item);
        });
        return menu;
    }

    /** Keys that have no menu; they work while the picture has the focus. */
    void install(PictureView view) {
        view.setFocusable(true);
        bind(view, "LEFT", () -> light(-STEP, 0));
        bind(view, "RIGHT", () -> light(STEP, 0));
        bind(view, "UP", () -> light(0, STEP));
        bind(view, "DOWN", () -> light(0, -STEP));
        for (String key : new String[] {"typed +", "typed ="}) {
            bind(view, key, () -> zoom(1 / ZOOM));
        }
        bind(view, "typed -", () -> zoom(ZOOM));
    }

    private void light(double right, double up) {
        model.change(scene -> scene.withLight(new SceneLight(
                Drags.light(scene.view().camera(), scene.light().towards(), right, up),
                scene.light().intensity())));
    }

    private void zoom(double factor) {
        model.change(scene -> scene.withView(Drags.zoomed(scene.view(), factor)));
    }

    private static void bind(JComponent component, String key, Runnable action) {
        component.getInputMap().put(KeyStroke.getKeyStroke(key), key);
        component.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    /** Leaves letters to a text that is being typed: the m of "65um" is no command. */
    private static final class Menus extends JMenuBar {
        @Override
        protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
            int key = stroke.getKeyCode();
            boolean letter = key >= KeyEvent.VK_A && key <= KeyEvent.VK_Z && stroke.getModifiers() == 0;
            boolean typed = letter && event.getComponent() instanceof JTextComponent;
            return !typed && super.processKeyBinding(stroke, event, condition, pressed);
        }
    }
}
