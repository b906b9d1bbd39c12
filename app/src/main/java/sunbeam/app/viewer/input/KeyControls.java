package sunbeam.app.viewer.input;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.viewer.window.Viewer;
import sunbeam.app.viewer.window.ViewerWindow;

/** Menus and key bindings of a viewer, made from the {@link Action}s. */
public final class KeyControls {
    private KeyControls() {}

    public static void install(Viewer viewer) {
        ViewerWindow window = viewer.window();
        window.picture().setFocusable(true);
        Map<String, JMenu> menus = new LinkedHashMap<>();
        for (Action action : Action.values()) {
            boolean hasMenu = !action.menu().isEmpty();
            if (hasMenu) {
                menus.computeIfAbsent(action.menu(), name -> new JMenu(name)).add(item(viewer, action));
            }
            for (KeyStroke stroke :
                    action.strokes().subList(hasMenu ? 1 : 0, action.strokes().size())) {
                JComponent owner = hasMenu ? window.getRootPane() : window.picture();
                int condition = hasMenu ? JComponent.WHEN_IN_FOCUSED_WINDOW : JComponent.WHEN_FOCUSED;
                owner.getInputMap(condition).put(stroke, stroke);
                owner.getActionMap().put(stroke, new AbstractAction() {
                    @Override
                    public void actionPerformed(ActionEvent event) {
                        action.run(viewer, stroke);
                    }
                });
            }
        }
        JMenuBar bar = new Menus();
        menus.values().forEach(bar::add);
        bar.add(scenes(viewer), 1);
        for (int i = 0; i < bar.getMenuCount(); i++) {
            bar.getMenu(i).setMnemonic(bar.getMenu(i).getText().charAt(0));
        }
        window.setJMenuBar(bar);
    }

    private static JMenuItem item(Viewer viewer, Action action) {
        String description = action.description();
        JMenuItem item = new JMenuItem(description.substring(0, 1).toUpperCase(Locale.ROOT) + description.substring(1));
        KeyStroke stroke = action.strokes().get(0);
        item.setAccelerator(stroke);
        item.addActionListener(event -> action.run(viewer, stroke));
        return item;
    }

    private static JMenu scenes(Viewer viewer) {
        JMenu menu = new JMenu("Scenes");
        for (String name : Scenes.builtIn()) {
            JMenuItem item = new JMenuItem(name);
            item.setToolTipText(Scenes.load(name).get(SceneSettings.TITLE));
            item.addActionListener(event -> viewer.open(Scenes.load(name), () -> {}));
            menu.add(item);
        }
        return menu;
    }

    /** Menu bar that ignores letters while a text field has the focus, so that typing the m of "65um" does not toggle the map. */
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
