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

/** What is on screen, how fast it came and by what method; and the last message, which stands elsewhere. */
public final class StatusLine extends JPanel {
    // Nobody reads faster, and each text has the line laid out and painted anew.
    private static final long BETWEEN_TEXTS = 200_000_000;

    private final JLabel picture = new JLabel("Loading");
    private final JLabel method = new JLabel(" ", SwingConstants.TRAILING);
    private String renderer = "";
    private final JTextArea message = new JTextArea();
    // Of what moves: frames since a moment, and what that made in a second; 0 while nothing moves.
    private int frames;
    private long since;
    private String rate = "";
    // Stands in place of what is reported of an old picture; empty while there is none.
    private String loading = "";
    // Since when the same is being made, for the time that is left.
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
        // What does not fit ends in an ellipsis.
        add(picture);
        add(method, BorderLayout.EAST);
    }

    /** Where the last message stands; hidden without one. */
    JTextArea messageArea() {
        return message;
    }

    /** A frame of what moves is on screen. */
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

    /** A finer picture of what stands still is on screen. */
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

    /** The picture is not of what is asked for now; a newer one follows. */
    void outdated() {
        if (since == 0) {
            report("Preview");
        }
    }

    /** Nothing newer can be drawn. */
    void refused() {
        loading = "";
        report("No picture of this scene");
    }

    /** The picture will be of something that is being loaded. */
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

    /** @param name who draws, GL_RENDERER */
    void renderer(String name) {
        renderer = name;
    }

    /** By what method and tolerance the picture on screen is drawn, and what that has planned, a line each. */
    void method(String words, List<String> details) {
        method.setText(words);
        method.setToolTipText("<html>" + String.join("<br>", details) + "<br>drawn by " + renderer);
    }

    /** A message, until the next or a click on it; a blank one clears it. */
    final void message(String text) {
        message.setText(text);
        message.setVisible(!text.isBlank());
    }

    public String text() {
        return message.getText();
    }
}
