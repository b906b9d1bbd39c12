package sunbeam.app.viewer;

import java.util.ArrayList;
import java.util.List;
import javax.swing.Timer;
import sunbeam.app.scene.Motion;
import sunbeam.app.viewer.model.ViewerModel;

/** Plays one {@link Motion} of the scene at a time until it is stopped. Used on the event thread only. */
public final class Player {
    private static final int FRAME_MILLISECONDS = 16;
    private static final double RADIANS_PER_NANOSECOND = Math.toRadians(30) * 1e-9;

    private final ViewerModel model;
    private final Timer timer = new Timer(FRAME_MILLISECONDS, event -> advance());
    private final List<Runnable> listeners = new ArrayList<>();
    private Motion motion;
    private long last;

    Player(ViewerModel model) {
        this.model = model;
    }

    public void onChange(Runnable listener) {
        listeners.add(listener);
    }

    public boolean plays(Motion value) {
        return motion == value;
    }

    public void toggle(Motion value) {
        play(plays(value) ? null : value);
    }

    public void stop() {
        play(null);
    }

    private void play(Motion value) {
        motion = value;
        last = System.nanoTime();
        if (value == null) {
            timer.stop();
        } else {
            timer.start();
        }
        listeners.forEach(Runnable::run);
    }

    private void advance() {
        long now = System.nanoTime();
        double angle = (now - last) * RADIANS_PER_NANOSECOND;
        last = now;
        model.change(scene -> motion.at(scene, angle));
    }
}
