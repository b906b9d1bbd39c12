package sunbeam.app.viewer;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import javax.swing.Box;
import javax.swing.ImageIcon;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.viewer.Action.Group;

/** Menus and key bindings of a viewer, made from the {@link Action}s. */
public final class KeyControls {
    private KeyControls() {}

    public static void install(Viewer viewer) {
        ViewerWindow window = viewer.window;
        window.picture.setFocusable(true);
        Map<String, JMenu> menus = new LinkedHashMap<>();
        for (Action action : Action.values()) {
            boolean hasMenu = action.help.group().hasMenu;
            if (hasMenu) {
                JMenu menu = menus.computeIfAbsent(action.help.group().title, title -> new JMenu(title));
                menu.add(item(viewer, action, menu));
            }
            if (action == Action.LOAD_TEXTURE) {
                menus.get(Group.FILE.title).add(recent(viewer));
            }
            JComponent owner = hasMenu ? window.getRootPane() : window.picture;
            int condition = hasMenu ? JComponent.WHEN_IN_FOCUSED_WINDOW : JComponent.WHEN_FOCUSED;
            // The menu has the first key.
            for (KeyStroke stroke :
                    action.strokes().subList(hasMenu ? 1 : 0, action.strokes().size())) {
                owner.registerKeyboardAction(event -> action.run(viewer, stroke), stroke, condition);
            }
        }
        // A key that is held while the window loses the focus is never released there.
        window.picture.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                for (Action action : Action.values()) {
                    action.strokes().stream()
                            .filter(KeyStroke::isOnKeyRelease)
                            .forEach(stroke -> action.run(viewer, stroke));
                }
            }
        });
        JMenuBar bar = new Menus();
        menus.values().forEach(bar::add);
        bar.add(scenes(viewer), 1);
        for (int i = 0; i < bar.getMenuCount(); i++) {
            bar.getMenu(i).setMnemonic(bar.getMenu(i).getText().charAt(0));
        }
        bar.add(Box.createHorizontalGlue());
        bar.add(playButton(viewer, Action.TURNTABLE, "Turntable"));
        bar.add(playButton(viewer, Action.LIGHT_SWEEP, "Light"));
        window.setJMenuBar(bar);
    }

    private static JMenuItem item(Viewer viewer, Action action, JMenu menu) {
        String description = action.help.description();
        String text = description.substring(0, 1).toUpperCase(Locale.ROOT) + description.substring(1);
        JMenuItem item = action.isSwitch() ? new JCheckBoxMenuItem(text) : new JMenuItem(text);
        KeyStroke stroke = action.strokes().get(0);
        item.setAccelerator(stroke);
        item.addActionListener(event -> action.run(viewer, stroke));
        if (action.isSwitch()) {
            onOpening(menu, () -> item.setSelected(action.isOn(viewer)));
        }
        // The key of a gray entry would do nothing, so entries are gray only in an open menu.
        menu.addItemListener(event -> item.setEnabled(!menu.isSelected() || action.isAvailable(viewer)));
        return item;
    }

    private static JToggleButton playButton(Viewer viewer, Action action, String text) {
        JToggleButton button = new JToggleButton("\u25b6 " + text);
        button.setName(action.name());
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setFocusable(false);
        button.setToolTipText(action.help.description() + " (" + action.help.input() + ")");
        button.addActionListener(event -> action.run(viewer, action.strokes().get(0)));
        viewer.player.onChange(() -> button.setSelected(action.isOn(viewer)));
        return button;
    }

    private static JMenu scenes(Viewer viewer) {
        JMenu menu = new JMenu("Scenes");
        onOpening(menu, () -> {
            menu.removeAll();
            for (String name : Scenes.builtIn()) {
                Scene scene = Scenes.load(name);
                JMenuItem item =
                        new JCheckBoxMenuItem(scene.get(SceneSettings.TITLE), new ImageIcon(Scenes.picture(name)));
                item.setSelected(scene.equals(viewer.sceneAsOpened));
                item.setToolTipText(name);
                item.addActionListener(event -> viewer.open(scene, () -> {}));
                menu.add(item);
            }
        });
        return menu;
    }

    private static JMenu recent(Viewer viewer) {
        JMenu menu = new JMenu("Load a recent file");
        onOpening(menu, () -> {
            menu.removeAll();
            for (Path file : viewer.files.recent.files()) {
                JMenuItem item = new JMenuItem(file.getFileName().toString());
                item.setToolTipText(file.toString());
                item.addActionListener(event -> viewer.files.load(file));
                menu.add(item);
            }
            if (menu.getItemCount() == 0) {
                menu.add("none yet").setEnabled(false);
            }
        });
        return menu;
    }

    private static void onOpening(JMenu menu, Runnable work) {
        menu.addItemListener(event -> {
            if (menu.isSelected()) {
                work.run();
            }
        });
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
