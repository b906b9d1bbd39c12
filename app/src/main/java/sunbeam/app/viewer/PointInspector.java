package sunbeam.app.viewer;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.joml.Vector3fc;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.app.viewer.PickPanel.Readout;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.color.ColorName;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** Inspector of one or two picked points: finds them, keeps them while the scene has the same mesh, and fills their panel. */
public final class PointInspector {
    private static final String NOTHING_PICKED = "nothing to copy: double-click the skin to pick a point";

    private final Viewer viewer;
    private final PictureView picture;
    private final PickPanel panel;
    // At most one for each of the panel's readouts, in their order.
    private final List<Inspected> picks = new ArrayList<>();

    private static final class Inspected {
        private final Readout readout;
        private SkinPoint point;
        // Inputs (see spectrumInputs()) of the spectrum requested last and of the displayed one; empty for none.
        private volatile List<Object> requestedInputs = List.of();
        private List<Object> displayedInputs = List.of();

        Inspected(SkinPoint point, Readout readout) {
            this.point = point;
            this.readout = readout;
        }
    }

    PointInspector(Viewer viewer) {
        this.viewer = viewer;
        picture = viewer.window.picture;
        panel = viewer.window.pick;
    }

    public Optional<SkinPoint> point() {
        return points().stream().findFirst();
    }

    public List<SkinPoint> points() {
        return picks.stream().map(pick -> pick.point).toList();
    }

    /** Finds the point under a pixel of the picture; passes it, or empty, on the event thread. */
    public void locate(int x, int y, Consumer<Optional<SkinPoint>> found) {
        int width = picture.pictureWidth();
        int height = picture.pictureHeight();
        if (viewer.model.loaded().isEmpty() || !new Rectangle(width, height).contains(x, y)) {
            return;
        }
        Scene scene = viewer.model.loaded().get().firstPart().scene();
        viewer.loop.submit(stage -> {
            Optional<SkinPoint> located = stage.pick(x, y, width, height).map(skin -> new SkinPoint(scene, skin));
            SwingUtilities.invokeLater(() -> found.accept(located));
        });
    }

    /** Picks the point under a pixel as the first or, beside it, as the second one; a pixel without skin removes it. */
    public void pick(int x, int y, boolean isBeside) {
        locate(x, y, located -> {
            keepFirst(isBeside ? Math.min(1, picks.size()) : 0);
            viewer.window.status.withdraw(NOTHING_PICKED);
            // The panel follows the object.
            located.filter(point -> point.staysIn(viewer.model.scene()))
                    .ifPresent(point ->
                            viewer.model.amend(scene -> scene.at(point.pick().object())));
            located.ifPresent(point -> picks.add(new Inspected(point, panel.readouts.get(picks.size()))));
            viewer.presenter.show();
            measure();
        });
    }

    /** Removes all points. */
    void clear() {
        keepFirst(0);
        describe();
    }

    private void keepFirst(int count) {
        stop();
        picks.subList(count, picks.size()).clear();
        panel.readouts.subList(count, panel.readouts.size()).forEach(Readout::clear);
        mark();
    }

    private void mark() {
        picture.mark(picks.stream()
                .map(pick -> pick.point.seen(picture.pictureWidth(), picture.pictureHeight()))
                .toList());
    }

    /** Removes all points if the mesh has changed; otherwise moves them with the model and dims spectra of other inputs. */
    public void follow(Scene scene) {
        if (picks.stream().anyMatch(pick -> !pick.point.staysIn(scene))) {
            keepFirst(0);
            return;
        }
        for (Inspected pick : picks) {
            pick.point = pick.point.in(scene);
            List<Object> inputs = spectrumInputs(pick.point, scene);
            if (!inputs.equals(pick.requestedInputs)) {
                pick.requestedInputs = List.of(); // discards the running computation
                pick.readout.curve.await(false);
            }
            pick.readout.outdate(!inputs.equals(pick.displayedInputs));
        }
        mark();
    }

    /** Describes the points under the newest light: a sentence and numbers. */
    public void describe() {
        Scene scene = viewer.model.litScene();
        Vector3fc towards = scene.light().towards();
        for (Inspected pick : picks) {
            double slopes = scene.at(pick.point.pick().object()).slopeDeviation();
            double spread = PickSentence.LEAST_SPREAD + 4 * slopes + 2 * scene.deviation(scene.light());
            List<SpatialFrequency> waves = viewer.model.loaded().stream()
                    .flatMap(loaded -> loaded
                            .ofPatch(
                                    pick.point.pick().object(),
                                    pick.point.pick().region())
                            .stream())
                    .findFirst()
                    .flatMap(part -> viewer.periods.find(part.patch()))
                    .filter(GratingPeriod::isSeen)
                    .map(GratingPeriod::waves)
                    .orElse(List.of());
            String sentence = new PickSentence(
                            pick.point.light(towards), pick.point.pick().wr(), waves, spread, scene.hasEnvironment())
                    .words(pick.readout.lab().map(ColorName::of));
            pick.readout.show(
                    sentence,
                    pick.point.describe(towards, picture.pictureWidth(), picture.pictureHeight()),
                    picks.size() > 1);
        }
        viewer.caption.accept(picks.isEmpty() ? viewer.presenter.verdict : panel.firstSentence());
    }

    private static List<Object> spectrumInputs(SkinPoint found, Scene scene) {
        Scene object = scene.at(found.pick().object());
        return List.of(found.pick(), scene.light().towards(), object.patches(), scene.method());
    }

    /** Shows the points' colors in the final picture and requests their spectra for the scene's light. */
    public void measure() {
        viewer.model.loaded().ifPresent(loaded -> picks.forEach(pick -> measure(pick, loaded)));
        describe();
    }

    private void measure(Inspected pick, LoadedScene loaded) {
        SkinPoint measured = pick.point;
        SceneData data = loaded.ofPatch(
                        measured.pick().object(), measured.pick().region())
                .get(0);
        Point pixel = measured.pixel(picture.pictureWidth(), picture.pictureHeight());
        picture.color(pixel.x, pixel.y).ifPresent(color -> pick.readout.showColor(color));
        List<Object> inputs = spectrumInputs(measured, data.lit());
        if (inputs.equals(pick.requestedInputs)) {
            return;
        }
        pick.requestedInputs = inputs;
        pick.readout.curve.await(true);
        Direction wi = measured.light(data.lit().light().towards());
        Direction wr = measured.pick().wr();
        Consumer<PickedLight.Spectrum> show = spectrum -> {
            if (inputs.equals(pick.requestedInputs)) {
                pick.displayedInputs = inputs;
                pick.readout.curve.show(spectrum);
            }
        };
        viewer.measuring.run(
                () -> wi.z() > 0 && wr.z() > 0
                        ? PickedLight.of(data.scene(), data.patch(), new DirectionPair(wi, wr))
                                .spectrum(
                                        coarse -> SwingUtilities.invokeLater(() -> show.accept(coarse)),
                                        () -> !inputs.equals(pick.requestedInputs))
                        : PickedLight.Spectrum.NONE,
                show,
                problem -> {
                    if (inputs.equals(pick.requestedInputs)) {
                        pick.readout.curve.await(false);
                    }
                    viewer.window.status.message(problem);
                });
    }

    public void copy() {
        if (picks.isEmpty()) {
            viewer.window.status.message(NOTHING_PICKED);
            return;
        }
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(panel.numbers()), null);
        viewer.window.status.message(
                picks.size() > 1 ? "copied both points' numbers" : "copied the picked point's numbers");
    }

    public void stop() {
        picks.forEach(pick -> pick.requestedInputs = List.of());
    }
}
