package sunbeam.app.viewer.input;

import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.KeyStroke;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.viewer.model.Drags;
import sunbeam.app.viewer.picture.Divider;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.app.viewer.window.FileKind;
import sunbeam.app.viewer.window.Viewer;

/** Key actions. Menus, key bindings, help and the table in docs/viewer.md derive from this enum. */
enum Action {
    LOAD_SCENE("File", "load a scene", "ctrl O", viewer -> viewer.files().load(FileKind.SCENE)),
    LOAD_PATCH("File", "load a patch", "ctrl L", viewer -> viewer.files().load(FileKind.PATCH)),
    LOAD_MESH("File", "load a mesh", "ctrl M", viewer -> viewer.files().load(FileKind.MESH)),
    LOAD_TEXTURE("File", "load a texture", "ctrl T", viewer -> viewer.files().load(FileKind.TEXTURE)),
    SAVE_SCENE("File", "save the scene", "ctrl S", viewer -> viewer.files().saveScene()),
    SAVE_PICTURE(
            "File",
            "save the picture, as soon as it is final",
            "ctrl P",
            viewer -> viewer.files().savePicture()),
    QUIT("File", "quit", "ctrl Q", Viewer::quit),
    UNDO("Edit", "undo the last change", "ctrl Z", viewer -> viewer.model().undo()),
    REDO(
            "Edit",
            "redo what was undone",
            "ctrl shift Z, ctrl Y",
            viewer -> viewer.model().redo()),
    COPY(
            "Edit",
            "copy the picked points' numbers",
            "ctrl C",
            viewer -> viewer.inspector().copy()),
    CONE(
            "View",
            "show or hide the light's cone",
            "L",
            viewer -> viewer.presenter().toggleCone()),
    STROKES(
            "View",
            "show or hide how the nanostructure lies",
            "N",
            viewer -> viewer.presenter().toggleStrokes()),
    MAP("View", "show or hide the BRDF map", "M", viewer -> viewer.presenter().toggleMap()),
    RESET("View", "back to the scene as it was loaded", "HOME", Viewer::reset),
    LIGHT("", "move the light by 2 degrees", "arrows", Action::moveLight),
    TURN("", "turn the model by 2 degrees", "shift arrows", Action::turn),
    PAN("", "pan by 2 % of the picture's height", "ctrl arrows", Action::pan),
    NEARER("", "zoom in", "typed +, typed =", viewer -> viewer.zoom(1 / 1.1)),
    FARTHER("", "zoom out", "typed -", viewer -> viewer.zoom(1.1)),
    OTHER(
            "",
            "while it is held, show the other method alone",
            "SPACE, released SPACE",
            (viewer, stroke) -> viewer.window().picture().divider().whole(!stroke.isOnKeyRelease())),
    DIVIDER("", "move the line between two methods", "alt LEFT, alt RIGHT", (viewer, stroke) -> {
        Divider divider = viewer.window().picture().divider();
        divider.move(divider.share() + Action.STEP_SHARE * right(stroke));
    }),
    HELP("Help", "list mouse and keys", "F1, typed ?", viewer -> Help.show(viewer.window()));

    private static final String ARROWS = "arrows";
    private static final double STEP_RADIANS = Math.toRadians(2);
    private static final double STEP_SHARE = 0.02;

    private final String menu;
    private final String description;
    private final String keys;

    @SuppressWarnings("ImmutableEnumChecker") // lambdas without state
    private final transient Effect effect;

    /** Effect of an action that depends on the pressed key. */
    @FunctionalInterface
    private interface Effect {
        void run(Viewer viewer, KeyStroke stroke);
    }

    /** Effect of an action that is the same for all of its keys. */
    @FunctionalInterface
    private interface KeylessEffect {
        void run(Viewer viewer);
    }

    Action(String menu, String description, String keys, KeylessEffect effect) {
        this(menu, description, keys, (viewer, stroke) -> effect.run(viewer));
    }

    /**
     * @param menu name of the menu; if empty, the keys work only while the picture has the focus
     * @param description description for menus and help
     * @param keys {@link KeyStroke} texts, separated by commas; {@code arrows} means all four arrow keys
     */
    Action(String menu, String description, String keys, Effect effect) {
        this.menu = menu;
        this.description = description;
        this.keys = keys;
        this.effect = effect;
    }

    private static void moveLight(Viewer viewer, KeyStroke stroke) {
        viewer.model()
                .change(scene -> scene.withLight(new SceneLight(
                        Drags.light(
                                scene.view().camera(),
                                scene.light().towards(),
                                right(stroke) * STEP_RADIANS,
                                up(stroke) * STEP_RADIANS),
                        scene.light().intensity())));
    }

    private static void turn(Viewer viewer, KeyStroke stroke) {
        viewer.model()
                .change(scene -> scene.withOrientation(Drags.turned(
                        scene.orientation(),
                        // Drags.turn rotates by twice the arc on its ball, so the arc is half the angle.
                        Drags.turn(
                                scene.view().camera(),
                                0,
                                0,
                                right(stroke) * STEP_RADIANS / 2,
                                up(stroke) * STEP_RADIANS / 2))));
    }

    private static void pan(Viewer viewer, KeyStroke stroke) {
        PictureView picture = viewer.window().picture();
        viewer.model()
                .change(scene -> scene.withView(Drags.panned(
                        scene.view(),
                        right(stroke) * STEP_SHARE,
                        up(stroke) * STEP_SHARE,
                        picture.getWidth(),
                        picture.getHeight())));
    }

    /** Returns the horizontal step of an arrow key: 1 for right, -1 for left, 0 for others. */
    private static int right(KeyStroke stroke) {
        int key = stroke.getKeyCode();
        return key == KeyEvent.VK_RIGHT ? 1 : key == KeyEvent.VK_LEFT ? -1 : 0;
    }

    private static int up(KeyStroke stroke) {
        int key = stroke.getKeyCode();
        return key == KeyEvent.VK_UP ? 1 : key == KeyEvent.VK_DOWN ? -1 : 0;
    }

    String menu() {
        return menu;
    }

    String description() {
        return description;
    }

    /** Returns all keys; menus show the first. */
    List<KeyStroke> strokes() {
        return Arrays.stream(keys.split(", ", -1))
                .flatMap(key -> key.endsWith(ARROWS)
                        ? Stream.of("LEFT", "RIGHT", "UP", "DOWN").map(arrow -> key.replace(ARROWS, arrow))
                        : Stream.of(key))
                .map(KeyStroke::getKeyStroke)
                .toList();
    }

    /** Returns the keys as text, such as Ctrl+Shift+Z. */
    String keyNames() {
        return Arrays.stream(keys.split(", ", -1))
                .filter(key -> !key.startsWith("released"))
                .map(key -> Arrays.stream(key.replace("typed ", "").split(" ", -1))
                        .map(Action::capitalized)
                        .collect(Collectors.joining("+")))
                .collect(Collectors.joining(", "));
    }

    private static String capitalized(String word) {
        return word.length() < 2 || word.matches("F[0-9]+")
                ? word
                : word.substring(0, 1).toUpperCase(Locale.ROOT)
                        + word.substring(1).toLowerCase(Locale.ROOT);
    }

    void run(Viewer viewer, KeyStroke stroke) {
        effect.run(viewer, stroke);
    }
}
