package sunbeam.app.viewer;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import javax.swing.SwingUtilities;
import org.joml.Vector3fc;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** The picked point of the skin: finds it, keeps it while it stays where it was, and fills its panel. */
final class PointInspector implements AutoCloseable {
    private final ViewerWindow window;
    private final Background measuring = new Background("spectrum");
    private final AtomicLong newestSpectrum = new AtomicLong();
    private Optional<PickedPoint> point = Optional.empty();

    PointInspector(ViewerWindow window) {
        this.window = window;
    }

    /** The point; empty before one is picked, and after it has moved. */
    Optional<PickedPoint> point() {
        return point;
    }

    /**
     * Looks for the point under a pixel of the picture.
     *
     * @param data what is being drawn, not what a load may bring
     * @param found told on the event thread once the point, or that there is none, is known
     */
    void pick(RenderLoop loop, SceneData data, int x, int y, Runnable found) {
        int width = window.picture().pictureWidth();
        int height = window.picture().pictureHeight();
        if (x < 0 || y < 0 || x >= width || y >= height) {
            return;
        }
        loop.submit(stage -> {
            Optional<Pick> pick = stage.pick(x, y, width, height);
            SwingUtilities.invokeLater(() -> {
                point = pick.map(skin -> new PickedPoint(data.scene(), skin, x, y));
                if (point.isEmpty()) {
                    window.pick().clear();
                }
                found.run();
            });
        });
    }

    /** Lets go of the point unless it is still where it was. */
    void follow(Scene scene) {
        if (point.isPresent() && !point.get().staysIn(scene)) {
            point = Optional.empty();
            window.pick().clear();
        }
    }

    /** Shows frame and angles for a light. */
    void showAngles(Vector3fc towards) {
        point.ifPresent(found -> window.pick().show(found.describe(towards)));
    }

    /** Shows colour and spectrum, from the picture on screen and for the light of what is drawn. */
    void measure(SceneData data) {
        long number = newestSpectrum.incrementAndGet();
        if (point.isEmpty()) {
            return;
        }
        PickedPoint measured = point.get();
        window.picture().color(measured.x(), measured.y()).ifPresent(window.pick()::showColor);
        Direction wi = measured.light(data.scene().light().towards());
        Direction wr = measured.pick().wr();
        if (wi.z() <= 0 || wr.z() <= 0) {
            window.pick().showSpectrum(new double[0]);
            return;
        }
        measuring.run(
                () -> Spectrum.of(data, new DirectionPair(wi, wr), () -> number != newestSpectrum.get()),
                powers -> {
                    if (number == newestSpectrum.get()) {
                        window.pick().showSpectrum(powers);
                    }
                },
                window.status()::message);
    }

    /** Gives up what is being computed. */
    @Override
    public void close() {
        newestSpectrum.incrementAndGet();
        measuring.close();
    }
}
