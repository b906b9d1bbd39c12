package sunbeam.app.viewer;

import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import sunbeam.app.scene.Motion;
import sunbeam.app.scene.Scene;
import sunbeam.app.viewer.FileActions.Kind;
import sunbeam.app.viewer.model.Drags;

/** Key actions, from which menus, key bindings and help derive; ActionsTest compares docs/viewer.md with them. */
@SuppressWarnings("ImmutableEnumChecker") // rows of texts, and lambdas without state
enum Action {
    TURN(
            Group.LIGHT,
            "turn the model by 2 degrees",
            "shift arrows",
            (viewer, stroke) -> move(viewer, stroke, Drags::turned)),
    ROLL(
            Group.LIGHT,
            "roll the model by 2 degrees",
            "ctrl shift LEFT, ctrl shift RIGHT",
            (viewer, stroke) -> move(viewer, stroke, (scene, right, up) -> Drags.rolled(scene, -right))),
    LIGHT(Group.LIGHT, "move the light by 2 degrees", "arrows", (viewer, stroke) -> move(viewer, stroke, Drags::lit)),
    FOLLOW(
            Group.LIGHT,
            "while it is held, the light follows the mouse",
            "L, released L",
            (viewer, stroke) -> viewer.window.picture.isLightHeld = !stroke.isOnKeyRelease()),
    TURNTABLE(Group.LIGHT, "start or stop the turntable", "T", Motion.TURNTABLE),
    LIGHT_SWEEP(Group.LIGHT, "start or stop the light's sweep around the model", "S", Motion.LIGHT_SWEEP),
    PAN(Group.CAMERA, "pan by 2 % of the picture's height", "ctrl arrows", Action::pan),
    NEARER(Group.CAMERA, "zoom in", "typed +, typed =", viewer -> zoom(viewer, 1 / 1.1)),
    FARTHER(Group.CAMERA, "zoom out", "typed -", viewer -> zoom(viewer, 1.1)),
    OTHER(
            Group.SKIN,
            "while it is held, show the other method alone",
            "SPACE, released SPACE",
            (viewer, stroke) -> viewer.window.picture.divider.whole(!stroke.isOnKeyRelease())),
    DIVIDER(Group.SKIN, "move the line between two methods", "alt LEFT, alt RIGHT", (viewer, stroke) -> {
        Divider divider = viewer.window.picture.divider;
        divider.move(divider.share() + Action.STEP_SHARE * right(stroke));
    }),
    LOAD_SCENE(Group.FILE, "load a scene", "ctrl O", viewer -> viewer.files.load(Kind.SCENE)),
    LOAD_PATCH(Group.FILE, "open a scan or another patch", "ctrl L", viewer -> viewer.files.load(Kind.PATCH)),
    LOAD_MESH(Group.FILE, "load a mesh", "ctrl M", viewer -> viewer.files.load(Kind.MESH)),
    LOAD_TEXTURE(Group.FILE, "load a texture", "ctrl T", viewer -> viewer.files.load(Kind.TEXTURE)),
    SAVE_SCENE(Group.FILE, "save the scene", "ctrl S", viewer -> viewer.files.saveScene()),
    SAVE_PICTURE(
            Group.FILE, "save the picture, as soon as it is final", "ctrl P", viewer -> viewer.files.savePicture()),
    QUIT(Group.FILE, "quit", "ctrl Q", Viewer::quit),
    UNDO(Group.EDIT, "undo the last change", "ctrl Z", viewer -> viewer.model.undo()),
    REDO(Group.EDIT, "redo what was undone", "ctrl shift Z, ctrl Y", viewer -> viewer.model.redo()),
    COPY(Group.EDIT, "copy the picked points' numbers", "ctrl C", viewer -> viewer.inspector.copy()),
    RESET(Group.EDIT, "back to the scene as it was loaded", "HOME", Viewer::reset),
    PANEL(
            Group.VIEW,
            "show or hide the panel",
            "F9",
            (viewer, stroke) -> viewer.window.showPanel(!viewer.window.panel.isVisible()),
            viewer -> viewer.window.panel.isVisible()),
    FULL_SCREEN(
            Group.VIEW,
            "enter or leave full screen",
            "F11",
            (viewer, stroke) -> viewer.window.toggleFullScreen(),
            viewer -> viewer.window.isFullScreen()),
    CONE(Group.VIEW, "show or hide the light's cone", "C", Overlay.CONE),
    STROKES(Group.VIEW, "show or hide how the nanostructure lies", "N", Overlay.STROKES),
    MAP(Group.VIEW, "show or hide the BRDF map", "M", Overlay.MAP),
    INSPECTION(Group.VIEW, "show the picture of inspect", "I", viewer -> viewer.inspections.show()),
    HELP(Group.HELP, "list mouse and keys", "F1, typed ?", viewer -> Help.show(viewer.window));

    private static final String ARROWS = "arrows";
    private static final double STEP_RADIANS = Math.toRadians(2);
    private static final double STEP_SHARE = 0.02;

    final Help help;
    private final String keys;
    private final transient BiConsumer<Viewer, KeyStroke> effect;
    private final transient Predicate<Viewer> state;

    Action(Group group, String description, String keys, Consumer<Viewer> effect) {
        this(group, description, keys, (viewer, stroke) -> effect.accept(viewer));
    }

    Action(Group group, String description, String keys, Motion motion) {
        this(
                group,
                description,
                keys,
                (viewer, stroke) -> viewer.player.toggle(motion),
                viewer -> viewer.player.plays(motion));
    }

    Action(Group group, String description, String keys, Overlay overlay) {
        this(
                group,
                description,
                keys,
                (viewer, stroke) -> viewer.presenter.toggle(overlay),
                viewer -> viewer.presenter.shows(overlay));
    }

    Action(Group group, String description, String keys, BiConsumer<Viewer, KeyStroke> effect) {
        this(group, description, keys, effect, null);
    }

    /**
     * @param group group of the help; without a menu, the keys work only while the picture has the focus
     * @param keys {@link KeyStroke} texts, separated by commas; {@code arrows} means all four arrow keys
     * @param state whether the action's switch is on; null for actions that are no switch
     */
    Action(
            Group group,
            String description,
            String keys,
            BiConsumer<Viewer, KeyStroke> effect,
            Predicate<Viewer> state) {
        this.help = new Help(group, names(keys), description);
        this.keys = keys;
        this.effect = effect;
        this.state = state;
    }

    private interface Move {
        Scene of(Scene scene, double right, double up);
    }

    private static void move(Viewer viewer, KeyStroke stroke, Move move) {
        viewer.model.change(scene -> move.of(scene, right(stroke) * STEP_RADIANS, up(stroke) * STEP_RADIANS));
    }

    static void zoom(Viewer viewer, double factor) {
        viewer.model.change(scene -> Drags.zoomed(scene, factor, 0, 0, 1, 1));
    }

    private static void pan(Viewer viewer, KeyStroke stroke) {
        PictureView picture = viewer.window.picture;
        double right = right(stroke) * STEP_SHARE;
        double up = up(stroke) * STEP_SHARE;
        viewer.model.change(scene -> Drags.panned(scene, right, up, picture.getWidth(), picture.getHeight()));
    }

    private static int right(KeyStroke stroke) {
        int key = stroke.getKeyCode();
        return key == KeyEvent.VK_RIGHT ? 1 : key == KeyEvent.VK_LEFT ? -1 : 0;
    }

    private static int up(KeyStroke stroke) {
        int key = stroke.getKeyCode();
        return key == KeyEvent.VK_UP ? 1 : key == KeyEvent.VK_DOWN ? -1 : 0;
    }

    boolean isSwitch() {
        return state != null;
    }

    boolean isOn(Viewer viewer) {
        return state.test(viewer);
    }

    List<KeyStroke> strokes() {
        return Arrays.stream(keys.split(", ", -1))
                .flatMap(key -> key.endsWith(ARROWS)
                        ? Stream.of("LEFT", "RIGHT", "UP", "DOWN").map(arrow -> key.replace(ARROWS, arrow))
                        : Stream.of(key))
                .map(KeyStroke::getKeyStroke)
                .toList();
    }

    private static String names(String keys) {
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
                : Character.toUpperCase(word.charAt(0)) + word.substring(1).toLowerCase(Locale.ROOT);
    }

    void run(Viewer viewer, KeyStroke stroke) {
        viewer.window.picture.hideHint();
        effect.accept(viewer, stroke);
    }

    /** Returns whether the action would do anything now; its menu entry is gray otherwise. */
    boolean isAvailable(Viewer viewer) {
        return switch (this) {
            case UNDO -> viewer.model.canUndo();
            case REDO -> viewer.model.canRedo();
            case COPY -> viewer.inspector.point().isPresent();
            case INSPECTION -> viewer.inspections.inspection.isPresent();
            default -> true;
        };
    }

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

    /**
     * Row of the help window and of the table in docs/viewer.md.
     *
     * @param input gesture or keys
     */
    record Help(Group group, String input, String description) {
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
                            .collect(Collectors.joining(
                                    "", "<tr><td colspan='2'><u>" + group.title + "</u></td></tr>", "")))
                    .collect(Collectors.joining(
                            "<tr><td>&nbsp;</td></tr>", "<html><table cellpadding='1'>", "</table>"));
            JLabel table = new JLabel(rows.replace("<td>", "<td style='font-weight:normal'>"));
            JScrollPane list = new JScrollPane(table);
            int room = window.getWidth() - 120;
            if (table.getPreferredSize().width > room) {
                table.setText(table.getText().replace("<table ", "<table width='" + room + "' "));
            }
            Dimension whole = list.getPreferredSize();
            list.setPreferredSize(new Dimension(
                    Math.min(whole.width + 24, window.getWidth() - 80),
                    Math.min(whole.height + 8, window.getHeight() - 120)));
            list.setBorder(null);
            JOptionPane.showMessageDialog(window, list, "Mouse and keys", JOptionPane.PLAIN_MESSAGE);
        }
    }
}
