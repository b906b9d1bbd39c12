package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;

/** What is on screen, how fast it came and who drew it; below, the last message. */
final class StatusLine extends JPanel {
    private static final long SECOND = 1_000_000_000;
    // A second, of frames.
    private static final int MOST_TEXTS = 5;
    // Always, lest the picture change its size with each message; longer ones are scrolled.
    private static final int MESSAGE_ROWS = 2;

    private final JLabel picture = new JLabel("Loading");
    private final JLabel renderer = new JLabel(" ", SwingConstants.TRAILING);
    private final JTextArea message = new JTextArea(" ", MESSAGE_ROWS, 0);
    private final transient Deque<Long> frames = new ArrayDeque<>();
    private long lastNanoseconds;
    // When a frame was last told of; 0 where something else has been since.
    private long told;
    // Stands in place of what is told of an old picture; empty while there is none.
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
        frames.add(now);
        while (now - frames.peekFirst() > SECOND) {
            frames.removeFirst();
        }
        lastNanoseconds = nanoseconds;
        // Nobody reads faster, and each text has the line laid out and painted anew.
        if (told != 0 && now - told < SECOND / MOST_TEXTS) {
            return;
        }
        String scale = divisor > 1 ? " 1:" + divisor : "";
        tell("Preview" + scale + " · " + rate());
        told = now;
    }

    void refining(double share) {
        tell(format("Preview, %.0f %% final · ", Math.floor(100 * share)) + rate());
    }

    void waiting(double share) {
        tell(format("Preview, %.0f %% of its colors made · ", Math.floor(100 * share)) + rate());
    }

    void complete(long nanoseconds) {
        tell(format("Final · %.2f s · ", nanoseconds * 1e-9) + rate());
    }

    /** The picture is not of what is asked for now; a newer one follows. */
    void outdated() {
        tell("Preview · " + rate());
    }

    /** Nothing newer can be drawn. */
    void refused() {
        loading = "";
        tell("No picture of this scene");
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

    private void tell(String text) {
        told = 0;
        if (loading.isEmpty()) {
            picture.setText(text);
        }
    }

    /** Frames per second as the last second had them, or as the last frame's time would allow. */
    private String rate() {
        double perSecond = frames.size() > 1
                ? (frames.size() - 1) * (double) SECOND / Math.max(1, frames.peekLast() - frames.peekFirst())
                : (double) SECOND / Math.max(1, lastNanoseconds);
        return format("%.0f frames/s · %.0f ms per frame", perSecond, lastNanoseconds * 1e-6);
    }

    /** How the final picture is computed. */
    void plan(String summary) {
        picture.setToolTipText("Preview or final; frames per second; milliseconds per frame. Plan: " + summary);
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
