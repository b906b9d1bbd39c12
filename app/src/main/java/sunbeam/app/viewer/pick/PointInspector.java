package sunbeam.app.viewer.pick;

import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.ArrayList;
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

/** One or two picked points of the skin: finds them, keeps them while they stay where they were, and fills their panel. */
public final class PointInspector {
    private final PictureView picture;
    private final PickPanel panel;
    private final Consumer<String> message;
    private final Background measuring;
    // At most two, in the order of the panel's.
    private final List<Inspected> picks = new ArrayList<>();

    /** A point, and what is known of it. */
    private static final class Inspected {
        private PickedPoint point;
        // What the newest spectrum depends on, as question() has it, and that which is shown.
        private volatile List<Object> asked = List.of();
        private List<Object> answered = List.of();

        Inspected(PickedPoint point) {
            this.point = point;
        }
    }

    /**
     * Without a point.
     *
     * @param measuring in which spectra are summed
     * @param message told what goes wrong, in a line
     */
    public PointInspector(PictureView picture, PickPanel panel, Background measuring, Consumer<String> message) {
        this.picture = picture;
        this.panel = panel;
        this.measuring = measuring;
        this.message = message;
    }

    /** The first point; empty before one is picked, and after it has moved. */
    public Optional<PickedPoint> point() {
        return points().stream().findFirst();
    }

    /** One or two points; none before one is picked, and after they have moved. */
    public List<PickedPoint> points() {
        return picks.stream().map(pick -> pick.point).toList();
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

    public void show(Optional<PickedPoint> located) {
        keep(0);
        located.map(Inspected::new).ifPresent(picks::add);
    }

    /** Has a point beside the first, in place of another second one; what is not on the skin leaves the first alone. */
    public void showBeside(Optional<PickedPoint> located) {
        keep(Math.min(1, picks.size()));
        located.map(Inspected::new).ifPresent(picks::add);
    }

    private void keep(int count) {
        stop();
        picks.subList(count, picks.size()).clear();
        for (int i = count; i < PickPanel.MOST; i++) {
            panel.clear(i);
        }
        mark();
    }

    private void mark() {
        picture.mark(picks.stream()
                .map(pick -> pick.point.seen(picture.pictureWidth(), picture.pictureHeight()))
                .toList());
    }

    /** Lets go of points that are not where they were, and dims what the panel has of another scene. */
    public void follow(Scene scene) {
        if (picks.stream().anyMatch(pick -> !pick.point.staysIn(scene))) {
            keep(0);
            return;
        }
        for (int i = 0; i < picks.size(); i++) {
            Inspected pick = picks.get(i);
            pick.point = pick.point.in(scene);
            List<Object> question = question(pick.point, scene);
            if (!question.equals(pick.asked)) {
                pick.asked = List.of(); // what is being computed is out of date
                panel.awaitSpectrum(i, false);
            }
            panel.outdate(i, !question.equals(pick.answered));
        }
        mark();
    }

    /** Shows frames and angles for a light. */
    public void showAngles(Vector3fc towards) {
        for (int i = 0; i < picks.size(); i++) {
            PickedPoint found = picks.get(i).point;
            panel.show(i, found.describe(towards, pixel(found)));
        }
    }

    private Point pixel(PickedPoint found) {
        return found.pixel(picture.pictureWidth(), picture.pictureHeight());
    }

    /** All that a point's spectrum depends on. */
    private static List<Object> question(PickedPoint found, Scene scene) {
        return List.of(found.pick(), scene.light().towards(), scene.patches(), scene.method());
    }

    /** Shows colors and spectra, from the final picture on screen and for the light of what is drawn. */
    public void measure(LoadedScene loaded) {
        for (int i = 0; i < picks.size(); i++) {
            measure(i, picks.get(i), loaded);
        }
    }

    private void measure(int index, Inspected pick, LoadedScene loaded) {
        PickedPoint measured = pick.point;
        SceneData data = loaded.ofRegion(measured.pick().region()).get(0);
        Point pixel = pixel(measured);
        picture.color(pixel.x, pixel.y).ifPresent(color -> panel.showColor(index, color));
        List<Object> question = question(measured, data.scene());
        if (question.equals(pick.asked)) {
            return;
        }
        pick.asked = question;
        panel.awaitSpectrum(index, true);
        Direction wi = measured.light(data.scene().light().towards());
        Direction wr = measured.pick().wr();
        measuring.run(
                () -> wi.z() > 0 && wr.z() > 0
                        ? Spectrum.of(data, new DirectionPair(wi, wr), () -> !question.equals(pick.asked))
                        : new double[0],
                powers -> {
                    if (question.equals(pick.asked)) {
                        pick.answered = question;
                        panel.showSpectrum(index, powers);
                    }
                },
                problem -> {
                    if (question.equals(pick.asked)) {
                        panel.awaitSpectrum(index, false);
                    }
                    message.accept(problem);
                });
    }

    public void copy() {
        if (picks.isEmpty()) {
            message.accept("nothing to copy: double-click the skin to pick a point");
            return;
        }
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(panel.numbers()), null);
        message.accept(picks.size() > 1 ? "copied both points' numbers" : "copied the picked point's numbers");
    }

    /** Gives up what is being computed. */
    public void stop() {
        picks.forEach(pick -> pick.asked = List.of());
    }
}
