package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;

/** What is on screen, how fast it came and who drew it; below, the last message. */
final class StatusLine extends JPanel {
    // Nobody reads faster, and each text has the line laid out and painted anew.
    private static final long BETWEEN_TEXTS = 200_000_000;
    // Always, lest the picture change its size with each message; longer ones are scrolled.
    private static final int MESSAGE_ROWS = 2;

    private final JLabel picture = new JLabel("Loading");
    private final JLabel renderer = new JLabel(" ", SwingConstants.TRAILING);
    private final JTextArea message = new JTextArea(" ", MESSAGE_ROWS, 0);
    private long lastNanoseconds;
    // When a frame was last reported; 0 where something else has been since.
    private long reported;
    // Stands in place of what is reported of an old picture; empty while there is none.
    private String loading = "";

    StatusLine() {
        super(new BorderLayout(16, 2));
        setBorder(BorderFactory.createEmptyBorder(4, 12, 5, 12));
        picture.setName("status");
        renderer.setToolTipText("Who draws (GL_RENDERER)");
        message.setName("message");
        message.setEditable(false);
        message.setFocusable(false);
        message.setOpaque(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        message.setFont(picture.getFont());
        message.setBorder(null);
        add(picture, BorderLayout.WEST);
        add(renderer);
        JScrollPane scroll = new JScrollPane(message);
        scroll.setBorder(null);
        add(scroll, BorderLayout.SOUTH);
    }

    void preview(int divisor, long nanoseconds) {
        long now = System.nanoTime();
        lastNanoseconds = nanoseconds;
        if (reported != 0 && now - reported < BETWEEN_TEXTS) {
            return;
        }
        String scale = divisor > 1 ? " 1:" + divisor : "";
        report("Preview" + scale + " · " + rate());
        reported = now;
    }

    void refining(double share) {
        report(format("Preview, %.0f %% final · ", Math.floor(100 * share)) + rate());
    }

    void waiting(double share) {
        report(format("Preview, %.0f %% of its colors made · ", Math.floor(100 * share)) + rate());
    }

    void complete(long nanoseconds) {
        report(format("Final · %.2f s · ", nanoseconds * 1e-9) + rate());
    }

    /** The picture is not of what is asked for now; a newer one follows. */
    void outdated() {
        report("Preview · " + rate());
    }

    /** Nothing newer can be drawn. */
    void refused() {
        loading = "";
        report("No picture of this scene");
    }

    /** The picture will be of something that is being loaded. */
    void loading(String name, double share) {
        loading = "Loading " + name + (share > 0 ? format(", %.0f %%", 100 * share) : "");
        picture.setText(loading);
    }

    /** What was loaded is on screen. */
    void loaded() {
        loading = "";
    }

    private void report(String text) {
        reported = 0;
        if (loading.isEmpty()) {
            picture.setText(text);
        }
    }

    private String rate() {
        return format("%.0f ms per frame", lastNanoseconds * 1e-6);
    }

    /** How the final picture is computed. */
    void plan(String summary) {
        picture.setToolTipText("Preview or final; milliseconds per frame. Plan: " + summary);
    }

    void renderer(String name) {
        renderer.setText(name);
    }

    /** A message, until the next; a blank one clears it. */
    void message(String text) {
        message.setText(text);
        message.setCaretPosition(0);
    }

    /** The last message. */
    String text() {
        return message.getText();
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
