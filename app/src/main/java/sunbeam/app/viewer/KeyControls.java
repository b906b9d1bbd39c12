package sunbeam.app.viewer;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import sunbeam.app.scene.SceneLight;

/** Menus, and what the keys do. */
final class KeyControls {
    private static final double STEP = Math.toRadians(2);
    private static final double ZOOM = 1.1;

    private final Viewer viewer;
    private final ViewerModel model;
    private final FileActions files;

    KeyControls(Viewer viewer, ViewerModel model, FileActions files) {
        this.viewer = viewer;
        this.model = model;
        this.files = files;
    }

    JMenuBar menus() {
        JMenuBar bar = new JMenuBar();
        bar.add(menu("File", fileItems()));
        bar.add(menu("View", viewItems()));
        bar.add(menu("Help", Map.of("Mouse and keys\tF1", viewer::showKeys)));
        return bar;
    }

    private Map<String, Runnable> fileItems() {
        Map<String, Runnable> items = new LinkedHashMap<>();
        items.put("Load scene ...\tctrl O", files::loadScene);
        items.put("Save scene ...\tctrl S", files::saveScene);
        items.put("Load patch ...\tctrl L", files::loadPatch);
        items.put("Save picture ...\tctrl P", files::savePicture);
        items.put("Quit\tctrl Q", viewer::quit);
        return items;
    }

    private Map<String, Runnable> viewItems() {
        Map<String, Runnable> items = new LinkedHashMap<>();
        items.put("Light's cone\tL", viewer::toggleCone);
        items.put("BRDF map\tM", viewer::toggleMap);
        items.put("As loaded\tHOME", viewer::reset);
        return items;
    }

    private static JMenu menu(String name, Map<String, Runnable> items) {
        JMenu menu = new JMenu(name);
        items.forEach((text, action) -> {
            String[] parts = text.split("\t", -1);
            JMenuItem item = new Item(parts[0]);
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
                LightDrag.moved(scene.view().camera(), scene.light().towards(), right, up),
                scene.light().intensity())));
    }

    private void zoom(double factor) {
        model.change(scene -> scene.withView(CameraMoves.zoomed(scene.view(), factor)));
    }

    /** An item whose key, if it is a plain one such as L, is left to a text field that has the focus. */
    private static final class Item extends JMenuItem {
        Item(String text) {
            super(text);
        }

        @Override
        protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
            boolean typing = stroke.getModifiers() == 0
                    && event.getComponent() instanceof JTextComponent field
                    && field.isEditable()
                    && Character.isLetter(event.getKeyChar());
            return !typing && super.processKeyBinding(stroke, event, condition, pressed);
        }
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
}
