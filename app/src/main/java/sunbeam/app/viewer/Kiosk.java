package sunbeam.app.viewer;

import java.awt.AWTEvent;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Image;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.ImageIcon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;

/**
 * Viewer for an exhibition: full screen, without menu and panel; touch buttons beside the picture, a caption in large type below it. After
 * some time without a touch, the opening scene comes back. Only a key (Ctrl+Q) quits it. Used on the event thread only.
 */
final class Kiosk {
    private static final int REST_MILLISECONDS = 90_000;

    private static final List<String> SCENES = List.of("close-up", "elaphe", "disc");
    // Sides of a button, in Swing units; a fingertip needs 44.
    private static final int BUTTON = 96;
    private static final int LOWEST_BUTTON = 48;
    private static final float LARGE = 24;
    private static final float RESTING_OPACITY = 0.5f;

    private final Viewer viewer;
    private final Scene opening;
    private static final int CAPTION_LINES = 2;
    private static final int MARGIN = 10;

    private final JTextArea caption = new JTextArea();
    /** Runs out when nothing was touched for a while. */
    final Timer rest = new Timer(REST_MILLISECONDS, event -> begin());

    private Kiosk(Viewer viewer) {
        this.viewer = viewer;
        opening = viewer.model.scene();
        rest.setRepeats(false);
    }

    static void install(Viewer viewer) {
        Kiosk kiosk = new Kiosk(viewer);
        viewer.kiosk = Optional.of(kiosk);
        kiosk.arrange();
        AWTEventListener touches = event -> kiosk.rest.restart();
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(
                        touches,
                        AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK | AWTEvent.MOUSE_WHEEL_EVENT_MASK);
        viewer.window.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                Toolkit.getDefaultToolkit().removeAWTEventListener(touches);
                kiosk.rest.stop();
            }
        });
    }

    private void arrange() {
        ViewerWindow window = viewer.window;
        window.setUndecorated(true);
        window.getRootPane().setTransferHandler(null);
        window.getRootPane()
                .registerKeyboardAction(
                        event -> viewer.quit(), KeyStroke.getKeyStroke("ctrl Q"), JComponent.WHEN_IN_FOCUSED_WINDOW);
        window.showPanel(false);
        window.picture.hideHint();
        window.picture.light.restingOpacity = RESTING_OPACITY;
        viewer.presenter.toggle(Overlay.MAP);
        caption.setEditable(false);
        caption.setFocusable(false);
        caption.setLineWrap(true);
        caption.setWrapStyleWord(true);
        caption.setName("kiosk caption");
        caption.setFont(caption.getFont().deriveFont(Font.PLAIN, LARGE));
        caption.setBackground(window.status.getBackground());
        caption.setBorder(BorderFactory.createEmptyBorder(MARGIN, 2 * MARGIN, MARGIN, 2 * MARGIN));
        int line = caption.getFontMetrics(caption.getFont()).getHeight();
        caption.setPreferredSize(new Dimension(0, CAPTION_LINES * line + 2 * MARGIN));
        window.remove(window.status);
        window.add(caption, BorderLayout.SOUTH);
        window.add(buttons(), BorderLayout.LINE_START);
        // Until the verdict is known, the scene's title.
        viewer.caption =
                text -> caption.setText(text.isBlank() ? viewer.model.scene().get(SceneSettings.TITLE) : text);
        window.setSize(Toolkit.getDefaultToolkit().getScreenSize());
        window.setLocation(0, 0);
    }

    private JComponent buttons() {
        Box bar = Box.createVerticalBox();
        bar.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
        for (String name : SCENES) {
            Scene scene = Scenes.load(name);
            Image picture = new ImageIcon(Scenes.picture(name)).getImage();
            int height = BUTTON * picture.getHeight(null) / picture.getWidth(null);
            JButton button = button("", () -> viewer.open(scene, () -> {}));
            button.setIcon(new ImageIcon(picture.getScaledInstance(BUTTON - 12, height - 9, Image.SCALE_SMOOTH)));
            button.setToolTipText(scene.get(SceneSettings.TITLE));
            button.setName(name);
            add(bar, button, height);
        }
        bar.add(Box.createVerticalGlue());
        add(bar, button("+", () -> Action.zoom(viewer, 1 / 1.25)), BUTTON);
        add(bar, button("\u2212", () -> Action.zoom(viewer, 1.25)), BUTTON);
        add(bar, button("Reset", this::reset), BUTTON);
        return bar;
    }

    private static void add(Box bar, JButton button, int height) {
        button.setPreferredSize(new Dimension(BUTTON, height));
        button.setMinimumSize(new Dimension(BUTTON, LOWEST_BUTTON));
        button.setMaximumSize(new Dimension(BUTTON, height));
        button.setAlignmentX(Component.CENTER_ALIGNMENT);
        bar.add(button);
        bar.add(Box.createVerticalStrut(8));
    }

    private static JButton button(String text, Runnable effect) {
        JButton button = new JButton(text);
        button.setFont(button.getFont().deriveFont(text.length() > 1 ? 20f : 36f));
        button.setFocusable(false);
        button.setName(text);
        button.addActionListener(event -> effect.run());
        return button;
    }

    private void reset() {
        viewer.player.stop();
        viewer.inspector.clear();
        viewer.reset();
    }

    /** Goes back to the opening scene; if its files have gone, a message says so and the last scene stays. */
    private void begin() {
        viewer.sceneAsOpened = opening;
        reset();
    }
}
