package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Status line: resolution, frame rate and method of the picture. Owns the text area of the last message, which the window places. */
public final class StatusLine extends JPanel {
    // Shortest time between texts in nanoseconds: each costs a layout and a paint.
    private static final long TEXT_INTERVAL = 200_000_000;

    private final JLabel picture = new JLabel("Loading");
    private final JLabel method = new JLabel(" ", SwingConstants.TRAILING);
    private final JLabel caption = new JLabel(" ");
    final JTextArea message = new JTextArea();
    // Frames since the last text about a moving picture; time of that text, 0 while nothing moves; frame rate as text.
    private int frames;
    private long rateStart;
    private String rate = "";
    // Text about the picture; and about a running load, which is shown instead, empty if none.
    private String aboutPicture = "";
    private String loading = "";
    private String progressPattern = "";
    private long progressStart;

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
        caption.setName("caption");
        add(caption, BorderLayout.NORTH);
        add(picture);
        add(method, BorderLayout.EAST);
    }

    /** Shows what the surface is like, in a sentence; a blank keeps the line's height. */
    void caption(String sentence) {
        caption.setText(sentence);
        caption.setToolTipText(sentence.isBlank() ? null : sentence);
    }

    /**
     * @param moves true if the picture's state is newer than that of the last one
     * @param lights words about the lights of an environment, or none
     */
    void preview(double divisor, boolean moves, String lights) {
        if (!moves) {
            report("Preview" + scale(divisor) + lights);
            return;
        }
        long now = System.nanoTime();
        frames++;
        if (rateStart == 0 || now - rateStart > TEXT_INTERVAL) {
            rate = rateStart == 0 ? "" : Text.format(" · %.0f frames/s", frames / ((now - rateStart) * 1e-9));
            show("Preview" + scale(divisor) + lights + rate);
            frames = 0;
            rateStart = now;
        }
    }

    static String scale(double divisor) {
        return divisor > 1 ? " 1:" + Decimals.format(divisor) : "";
    }

    /** @param pattern format of the share in percent */
    void progress(double share, String pattern) {
        if (!progressPattern.equals(pattern)) {
            progressPattern = pattern;
            progressStart = System.nanoTime();
        }
        rateStart = 0;
        show(Text.format(pattern, Math.floor(100 * share)) + remaining(progressStart, share));
    }

    /** Returns words about the remaining time of work; empty until that can be estimated. */
    static String remaining(long start, double share) {
        double seconds = (System.nanoTime() - start) * 1e-9;
        return seconds > 1 && share > 0.05 && share < 1
                ? Text.format(", about %.0f s left", Math.ceil(seconds * (1 - share) / share))
                : "";
    }

    void complete(long nanoseconds, OptionalInt lights) {
        String ofLights = lights.isPresent() ? Text.format(" · %d lights", lights.getAsInt()) : "";
        report(Text.format("Final after %.1f s", nanoseconds * 1e-9) + ofLights + rate.replace(" · ", " · moved at "));
    }

    void outdated() {
        if (rateStart == 0) {
            report("Preview");
        }
    }

    void refused() {
        loading = "";
        report("No picture of this scene");
    }

    void loading(Optional<Scene> shown, Scene newest, double share) {
        Scene old = shown.filter(
                        scene -> scene.objects().size() == newest.objects().size())
                .map(scene -> scene.at(newest.current()))
                .orElse(newest);
        String name = !old.mesh().equals(newest.mesh())
                ? new File(newest.mesh().name()).getName()
                : shown.isEmpty() || !old.patches().equals(newest.patches())
                        ? new File(newest.patch().patch()).getName()
                        : "method " + newest.method().type().label();
        loading = "Loading " + name + (share > 0 ? Text.format(", %.0f %%", 100 * share) : "");
        picture.setText(loading);
    }

    void loaded() {
        loading = "";
        picture.setText(aboutPicture);
    }

    private void report(String text) {
        progressPattern = "";
        rateStart = 0;
        show(text);
    }

    private void show(String text) {
        aboutPicture = text;
        if (loading.isEmpty()) {
            picture.setText(text);
        }
    }

    void method(SceneData data, String renderer) {
        MethodChoice choice = MethodChoice.of(data.scene());
        String tolerance =
                choice.hasTolerance() ? ", tolerance " + data.scene().choices().written(MethodSettings.TOLERANCE) : "";
        method.setText(choice + tolerance);
        List<String> details = new ArrayList<>(data.method().reasons());
        details.add(0, data.method().summary());
        details.add("drawn by " + renderer);
        method.setToolTipText("<html>" + String.join("<br>", details));
    }

    /** Until the next message or a click; a blank one clears it. */
    final void message(String text) {
        message.setText(text);
        message.setVisible(!text.isBlank());
    }

    /** Removes a message whose cause is gone, unless another has replaced it. */
    void withdraw(String text) {
        if (message.getText().equals(text)) {
            message("");
        }
    }
}
