package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;

/** What is on screen, how fast it came, by which plan and which renderer; and the last problem. */
final class StatusLine extends JPanel {
    private static final long SECOND = 1_000_000_000;
    // A second, of frames.
    private static final int MOST_TEXTS = 5;

    private final JLabel picture = new JLabel("Loading");
    private final JLabel plan = new JLabel(" ");
    private final JLabel renderer = new JLabel(" ");
    private final JLabel message = new JLabel(" ");
    private final JProgressBar progress = new JProgressBar();
    private final transient Deque<Long> frames = new ArrayDeque<>();
    private long lastNanoseconds;
    // When a frame was last told of; 0 where something else has been since.
    private long told;
    private int loads;

    StatusLine() {
        super(new BorderLayout(16, 2));
        setBorder(BorderFactory.createEmptyBorder(4, 12, 5, 12));
        picture.setName("status");
        picture.setToolTipText("Preview or final; frames per second; milliseconds per frame");
        plan.setToolTipText("The plan in force, by which the final picture is computed");
        plan.setName("plan");
        renderer.setToolTipText("Who draws (GL_RENDERER)");
        message.setName("message");
        progress.setIndeterminate(true);
        progress.setVisible(false);
        progress.setPreferredSize(new Dimension(90, 6));
        plan.setMinimumSize(new Dimension(10, 10));
        JPanel top = new JPanel(new BorderLayout(16, 0));
        top.add(picture, BorderLayout.WEST);
        top.add(message);
        top.add(progress, BorderLayout.EAST);
        add(top, BorderLayout.NORTH);
        add(plan);
        add(renderer, BorderLayout.EAST);
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
        told = now;
        String scale = divisor > 1 ? " 1:" + divisor : "";
        picture.setText("Preview" + scale + " · " + rate());
    }

    void refining(double share) {
        tell(format("Preview, %.0f %% final · ", 100 * share) + rate());
    }

    void waiting(double share) {
        tell(format("Preview, %.0f %% of its colours made · ", 100 * share) + rate());
    }

    void complete(long nanoseconds) {
        tell(format("Final · %.2f s · ", nanoseconds * 1e-9) + rate());
    }

    private void tell(String text) {
        told = 0;
        picture.setText(text);
    }

    /** Frames per second as the last second had them, or as the last frame's time would allow. */
    private String rate() {
        double perSecond = frames.size() > 1
                ? (frames.size() - 1) * (double) SECOND / Math.max(1, frames.peekLast() - frames.peekFirst())
                : (double) SECOND / Math.max(1, lastNanoseconds);
        return format("%.0f frames/s · %.0f ms per frame", perSecond, lastNanoseconds * 1e-6);
    }

    void plan(String summary) {
        plan.setText(summary);
    }

    void renderer(String name) {
        renderer.setText(name);
    }

    /** One line, until the next; a blank one clears it. */
    void message(String text) {
        message.setText(text);
        message.setToolTipText(text.isBlank() ? null : text);
    }

    /** The last message. */
    String text() {
        return message.getText();
    }

    /** Shows that something is being loaded or saved. */
    void busy(boolean active) {
        loads = Math.max(0, loads + (active ? 1 : -1));
        progress.setVisible(loads > 0);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
