package sunbeam.app.viewer;

import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** The picked point of the skin: finds it, keeps it while it stays where it was, and fills its panel. */
final class PointInspector implements AutoCloseable {
    private final ViewerWindow window;
    private final Background measuring = new Background("spectrum");
    private Optional<PickedPoint> point = Optional.empty();
    // What the newest spectrum depends on, as question() has it, and that which is shown.
    private volatile List<Object> asked = List.of();
    private List<Object> answered = List.of();

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
    void locate(RenderLoop loop, SceneData data, int x, int y, Consumer<Optional<PickedPoint>> found) {
        int width = window.picture().pictureWidth();
        int height = window.picture().pictureHeight();
        if (x < 0 || y < 0 || x >= width || y >= height) {
            return;
        }
        loop.submit(stage -> {
            Optional<PickedPoint> located =
                    stage.pick(x, y, width, height).map(skin -> new PickedPoint(data.scene(), skin));
            SwingUtilities.invokeLater(() -> found.accept(located));
        });
    }

    /** Goes over to a point, or to none. */
    void show(Optional<PickedPoint> located) {
        clear();
        point = located;
    }

    private void clear() {
        point = Optional.empty();
        asked = List.of();
        answered = List.of();
        window.pick().clear();
        window.picture().mark(Optional.empty());
    }

    /** Lets go of the point unless it is still where it was, and dims what the panel has of another scene. */
    void follow(Scene scene) {
        point.ifPresent(found -> {
            if (!found.staysIn(scene)) {
                clear();
                return;
            }
            point = Optional.of(found.in(scene));
            window.picture()
                    .mark(point.get()
                            .seen(
                                    window.picture().pictureWidth(),
                                    window.picture().pictureHeight()));
            List<Object> question = question(point.get(), scene);
            if (!question.equals(asked)) {
                asked = List.of(); // what is being computed is out of date
            }
            window.pick().outdate(!question.equals(answered));
        });
    }

    /** Shows frame and angles for a light. */
    void showAngles(Vector3fc towards) {
        point.ifPresent(found -> window.pick().show(found.describe(towards, pixel(found))));
    }

    private Point pixel(PickedPoint found) {
        return found.pixel(window.picture().pictureWidth(), window.picture().pictureHeight());
    }

    /** All that a point's spectrum depends on. */
    private static List<Object> question(PickedPoint found, Scene scene) {
        return List.of(found.pick(), scene.light().towards(), scene.patches(), scene.method());
    }

    /** Shows color and spectrum, from the final picture on screen and for the light of what is drawn. */
    void measure(LoadedScene loaded) {
        if (point.isEmpty()) {
            return;
        }
        PickedPoint measured = point.get();
        SceneData data = loaded.ofRegion(measured.pick().region()).get(0);
        Point pixel = pixel(measured);
        window.picture().color(pixel.x, pixel.y).ifPresent(window.pick()::showColor);
        List<Object> question = question(measured, data.scene());
        if (question.equals(asked)) {
            return;
        }
        asked = question;
        Direction wi = measured.light(data.scene().light().towards());
        Direction wr = measured.pick().wr();
        measuring.run(
                () -> wi.z() > 0 && wr.z() > 0
                        ? Spectrum.of(data, new DirectionPair(wi, wr), () -> !question.equals(asked))
                        : new double[0],
                powers -> {
                    if (question.equals(asked)) {
                        answered = question;
                        window.pick().showSpectrum(powers);
                    }
                },
                window.status()::message);
    }

    /** Puts the point's numbers on the clipboard, as text. */
    void copy() {
        if (point.isEmpty()) {
            window.status().message("nothing to copy: double-click the skin to pick a point");
            return;
        }
        Toolkit.getDefaultToolkit()
                .getSystemClipboard()
                .setContents(new StringSelection(window.pick().numbers()), null);
        window.status().message("copied the picked point's numbers");
    }

    /** Gives up what is being computed. */
    @Override
    public void close() {
        asked = List.of();
        measuring.close();
    }
}
