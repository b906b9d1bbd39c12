package sunbeam.app.viewer.pick;

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
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.model.Background;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** The picked point of the skin: finds it, keeps it while it stays where it was, and fills its panel. */
public final class PointInspector implements AutoCloseable {
    private final PictureView picture;
    private final PickPanel panel;
    private final Consumer<String> message;
    private final Background measuring = new Background("spectrum");
    private Optional<PickedPoint> point = Optional.empty();
    // What the newest spectrum depends on, as question() has it, and that which is shown.
    private volatile List<Object> asked = List.of();
    private List<Object> answered = List.of();

    /** @param message told what goes wrong, in a line */
    public PointInspector(PictureView picture, PickPanel panel, Consumer<String> message) {
        this.picture = picture;
        this.panel = panel;
        this.message = message;
    }

    /** The point; empty before one is picked, and after it has moved. */
    public Optional<PickedPoint> point() {
        return point;
    }

    /**
     * Looks for the point under a pixel of the picture.
     *
     * @param data what is being drawn, not what a load may bring
     * @param found told on the event thread once the point, or that there is none, is known
     */
    public void locate(RenderLoop loop, SceneData data, int x, int y, Consumer<Optional<PickedPoint>> found) {
        int width = picture.pictureWidth();
        int height = picture.pictureHeight();
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
    public void show(Optional<PickedPoint> located) {
        clear();
        point = located;
    }

    private void clear() {
        point = Optional.empty();
        asked = List.of();
        answered = List.of();
        panel.clear();
        picture.mark(Optional.empty());
    }

    /** Lets go of the point unless it is still where it was, and dims what the panel has of another scene. */
    public void follow(Scene scene) {
        point.ifPresent(found -> {
            if (!found.staysIn(scene)) {
                clear();
                return;
            }
            point = Optional.of(found.in(scene));
            picture.mark(point.get().seen(picture.pictureWidth(), picture.pictureHeight()));
            List<Object> question = question(point.get(), scene);
            if (!question.equals(asked)) {
                asked = List.of(); // what is being computed is out of date
            }
            panel.outdate(!question.equals(answered));
        });
    }

    /** Shows frame and angles for a light. */
    public void showAngles(Vector3fc towards) {
        point.ifPresent(found -> panel.show(found.describe(towards, pixel(found))));
    }

    private Point pixel(PickedPoint found) {
        return found.pixel(picture.pictureWidth(), picture.pictureHeight());
    }

    /** All that a point's spectrum depends on. */
    private static List<Object> question(PickedPoint found, Scene scene) {
        return List.of(found.pick(), scene.light().towards(), scene.patches(), scene.method());
    }

    /** Shows color and spectrum, from the final picture on screen and for the light of what is drawn. */
    public void measure(LoadedScene loaded) {
        if (point.isEmpty()) {
            return;
        }
        PickedPoint measured = point.get();
        SceneData data = loaded.ofRegion(measured.pick().region()).get(0);
        Point pixel = pixel(measured);
        picture.color(pixel.x, pixel.y).ifPresent(panel::showColor);
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
                        panel.showSpectrum(powers);
                    }
                },
                message);
    }

    /** Puts the point's numbers on the clipboard, as text. */
    public void copy() {
        if (point.isEmpty()) {
            message.accept("nothing to copy: double-click the skin to pick a point");
            return;
        }
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(panel.numbers()), null);
        message.accept("copied the picked point's numbers");
    }

    /** Gives up what is being computed. */
    @Override
    public void close() {
        asked = List.of();
        measuring.close();
    }
}
