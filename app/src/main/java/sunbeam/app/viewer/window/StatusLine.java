package sunbeam.app.viewer.window;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Status line: resolution, frame rate and method of the picture, and the area of the last message. */
public final class StatusLine extends JPanel {
    // Shortest time between texts: each costs a layout and a paint.
    private static final long BETWEEN_TEXTS = 200_000_000;

    private final JLabel picture = new JLabel("Loading");
    private final JLabel method = new JLabel(" ", SwingConstants.TRAILING);
    private String renderer = "";
    private final JTextArea message = new JTextArea();
    // Frames since the last report, and frames per second; 0 while nothing moves.
    private int frames;
    private long since;
    private String rate = "";
    // Text about a load, shown in place of an outdated picture's text; empty if none.
    private String loading = "";
    // Name and start of the current work, for the remaining time.
    private String making = "";
    private long begun;

    StatusLine() {
        super(new BorderLayout(16, 0));
        setBorder(BorderFactory.createEmptyBorder(4, 12, 5, 12));
        picture.setName("status");
        picture.setToolTipText("What is on screen; how many pictures a second it has while something moves");
        method.setName("method");
        message.setName("message");
        message.setEditable(false);
        message.setFocusable(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        message.setFont(picture.getFont());
        message.setBackground(getBackground());
        message.setBorder(BorderFactory.createEmptyBorder(5, 12, 5, 12));
        message.setToolTipText("A click hides it.");
        message.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                message("");
            }
        });
        message("");
        // A label cuts a long text with an ellipsis.
        add(picture);
        add(method, BorderLayout.EAST);
    }

    /** Returns the area of the last message; hidden if there is none. */
    JTextArea messageArea() {
        return message;
    }

    /** Reports a displayed frame of a moving picture. */
    void moving(double divisor) {
        long now = System.nanoTime();
        frames++;
        if (since == 0 || now - since > BETWEEN_TEXTS) {
            rate = since == 0 ? "" : Text.format(" · %.0f frames/s", frames / ((now - since) * 1e-9));
            show("Preview" + scale(divisor) + rate);
            frames = 0;
            since = now;
        }
    }

    /** Reports a displayed finer picture of a still scene. */
    void still(double divisor) {
        report("Preview" + scale(divisor));
    }

    private static String scale(double divisor) {
        return divisor > 1 ? " 1:" + Decimals.format(divisor) : "";
    }

    void refining(double share) {
        making(share, "Preview, %.0f %% final");
    }

    void waiting(double share) {
        making(share, "Preview, %.0f %% of its colors made");
    }

    private void making(double share, String pattern) {
        long now = System.nanoTime();
        if (!making.equals(pattern)) {
            making = pattern;
            begun = now;
        }
        double seconds = (now - begun) * 1e-9;
        String left = seconds > 1 && share > 0.05 && share < 1
                ? Text.format(", about %.0f s left", Math.ceil(seconds * (1 - share) / share))
                : "";
        since = 0;
        show(Text.format(pattern, Math.floor(100 * share)) + left);
    }

    void complete(long nanoseconds) {
        report(Text.format("Final after %.1f s", nanoseconds * 1e-9) + rate.replace(" · ", " · moved at "));
    }

    /** Marks the picture as outdated; a newer one follows. */
    void outdated() {
        if (since == 0) {
            report("Preview");
        }
    }

    /** Reports that the newest state cannot be drawn. */
    void refused() {
        loading = "";
        report("No picture of this scene");
    }

    /** Shows the name and share of a load. */
    void loading(String name, double share) {
        loading = "Loading " + name + (share > 0 ? Text.format(", %.0f %%", 100 * share) : "");
        picture.setText(loading);
    }

    void loaded() {
        loading = "";
    }

    private void report(String text) {
        making = "";
        since = 0;
        show(text);
    }

    private void show(String text) {
        if (loading.isEmpty()) {
            picture.setText(text);
        }
    }

    /** @param name GL_RENDERER */
    void renderer(String name) {
        renderer = name;
    }

    /** Sets the method and tolerance of the picture, and the lines of its plan. */
    void method(String words, List<String> details) {
        method.setText(words);
        method.setToolTipText("<html>" + String.join("<br>", details) + "<br>drawn by " + renderer);
    }

    /** Shows a message until the next one or a click; a blank one clears it. */
    final void message(String text) {
        message.setText(text);
        message.setVisible(!text.isBlank());
    }

    public String text() {
        return message.getText();
    }
}
