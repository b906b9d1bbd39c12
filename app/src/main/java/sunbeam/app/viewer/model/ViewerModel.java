package sunbeam.app.viewer.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.DoubleConsumer;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.precompute.setting.Choices;

/**
 * Model of the viewer: the scene that the user sees and changes. Used on the event thread only. Changes that need loading are loaded in the
 * background while the old parts stay on screen; if loading fails, the old parts stay.
 */
public final class ViewerModel {
    public interface Listener {
        void changed();

        /** Reports the completed share of the newest load, 0 to 1; 0 at its start. */
        void loading(double share);

        void problem(String message);
    }

    @FunctionalInterface
    public interface Loading {
        /** Calls {@link LoadedScene#load(sunbeam.app.render.SceneLoader, Scene, LoadedScene, DoubleConsumer)}. */
        LoadedScene load(Scene scene, LoadedScene previous, DoubleConsumer progress);
    }

    private final Loading loading;
    private final Background background;
    private Listener listener;
    private Scene wanted;
    private LoadedScene loaded;
    private final AtomicLong newestLoad = new AtomicLong();
    private Optional<Opening> opening = Optional.empty();
    private int metering;
    private final History history = new History();

    /** @param before the scene that comes back if the load of this number fails */
    private record Opening(long load, Scene before, Runnable opened) {}

    public ViewerModel(Scene scene, Loading loading, Background background) {
        this.wanted = scene;
        this.loading = loading;
        this.background = background;
    }

    public void setListener(Listener value) {
        listener = value;
    }

    public Scene scene() {
        return wanted;
    }

    /** Returns the scene that is drawn: that of the loaded parts, which may be older than {@link #scene}; without any, the newest. */
    public Scene drawnScene() {
        return loaded == null ? wanted : loaded.firstPart().scene();
    }

    /** Returns {@link #drawnScene} with the light of a point's numbers and BRDF map: the key light, or the brightest of an environment. */
    public Scene litScene() {
        return loaded == null ? wanted : loaded.firstPart().lit();
    }

    public Optional<LoadedScene> loaded() {
        return Optional.ofNullable(loaded);
    }

    public void change(UnaryOperator<Scene> change) {
        Scene next = change.apply(wanted);
        history.changed(wanted, next);
        set(next, false);
    }

    /** Changes the scene without a new undo step. */
    public void amend(UnaryOperator<Scene> change) {
        set(change.apply(wanted), false);
    }

    private void set(Scene next, boolean mustLoad) {
        boolean loads = mustLoad || loaded == null || !SceneSharing.sharesParts(next, wanted);
        wanted = next;
        // The old parts follow drags while others load, but are not drawn with another scene's view or weights.
        if (loaded != null && opening.isEmpty() && (loaded.firstPart().suits(next) || hasOldWeights(next))) {
            loaded = loaded.with(SceneSharing.withPartsOf(loaded.firstPart().scene(), next));
        }
        if (loads) {
            load();
        }
        listener.changed();
    }

    /** Returns the number of times that a scene was opened or {@link #meter} called; automatic exposure is kept until it increases. */
    public int metering() {
        return metering;
    }

    /** Makes the exposure automatic and has it metered anew. */
    public void meter() {
        metering++;
        change(scene -> scene.with(SceneSettings.EXPOSURE, OptionalDouble.empty()));
    }

    private boolean hasOldWeights(Scene next) {
        return weights(loaded.firstPart().scene()).equals(weights(next));
    }

    private static List<Choices> weights(Scene scene) {
        return scene.perObject().stream().map(Scene::weights).toList();
    }

    /** Opens a scene; if any part of it cannot be loaded, the previous scene comes back. */
    public void open(Scene scene, Runnable opened) {
        history.opened(wanted, scene);
        load(scene, opened);
    }

    public void setDragging(boolean drags) {
        history.setDragging(drags);
    }

    public boolean canUndo() {
        return History.leads(history.before, wanted);
    }

    public boolean canRedo() {
        return History.leads(history.undone, wanted);
    }

    public void undo() {
        history.undo(wanted).ifPresent(this::goTo);
    }

    public void redo() {
        history.redo(wanted).ifPresent(this::goTo);
    }

    private void goTo(Scene scene) {
        if (SceneSharing.sharesParts(scene, wanted)) {
            set(scene, false);
        } else {
            load(scene, () -> {});
        }
    }

    private void load(Scene scene, Runnable opened) {
        opening = Optional.of(
                new Opening(newestLoad.get() + 1, opening.map(Opening::before).orElse(wanted), opened));
        set(scene, true);
    }

    public void load() {
        long number = newestLoad.incrementAndGet();
        Scene scene = wanted;
        LoadedScene previous = loaded;
        listener.loading(0);
        DoubleConsumer progress = share -> SwingUtilities.invokeLater(() -> {
            if (number == newestLoad.get()) {
                listener.loading(share);
            }
        });
        background.run(
                () -> number == newestLoad.get() ? loading.load(scene, previous, progress) : null,
                result -> accept(number, result),
                message -> refuse(number, message));
    }

    /** Shows a load; even an outdated one is shown until the newer one is ready, unless that opens another scene. */
    private void accept(long number, LoadedScene result) {
        if (result == null || opening.filter(later -> later.load() > number).isPresent()) {
            return;
        }
        loaded = result.with(SceneSharing.withPartsOf(result.firstPart().scene(), wanted));
        opening.filter(done -> done.load() <= number).ifPresent(done -> {
            opening = Optional.empty();
            metering++;
            done.opened().run();
        });
        listener.changed();
    }

    private void refuse(long number, String message) {
        // Ignore failures of older loads: the newer load fails likewise or does not contain the faulty part.
        if (number != newestLoad.get()) {
            return;
        }
        if (loaded != null) {
            // Changes made to a scene that failed to open are discarded with it.
            wanted = SceneSharing.withPartsOf(
                    loaded.firstPart().scene(), opening.map(Opening::before).orElse(wanted));
            loaded = loaded.with(wanted);
        }
        opening = Optional.empty();
        listener.changed();
        listener.problem(message);
    }

    /** Undo and redo. A drag is one step. */
    static final class History {
        // Maximum number of steps, far more than a session needs; bounds memory.
        private static final int LONGEST = 500;
        // Wheel turns and key presses that follow each other within this time are one step.
        private static final long PAUSE_NANOSECONDS = 400_000_000;

        private final Deque<Scene> before = new ArrayDeque<>();
        private final Deque<Scene> undone = new ArrayDeque<>();
        private boolean isDragging;
        // True if the next change may join the last step, and the time of the last change in nanoseconds.
        private boolean isOpen;
        private long last;

        void setDragging(boolean drags) {
            isDragging = drags;
            isOpen = false;
        }

        void changed(Scene from, Scene to) {
            if (to.equals(from)) {
                return;
            }
            long now = System.nanoTime();
            if (!isOpen || (!isDragging && now - last > PAUSE_NANOSECONDS)) {
                before.push(from);
                if (before.size() > LONGEST) {
                    before.removeLast();
                }
            }
            undone.clear();
            isOpen = true;
            last = now;
        }

        void opened(Scene from, Scene to) {
            isOpen = false;
            changed(from, to);
            isOpen = false;
        }

        /** True if any of these scenes is another one than the present. */
        static boolean leads(Deque<Scene> scenes, Scene now) {
            return scenes.stream().anyMatch(scene -> !scene.equals(now));
        }

        Optional<Scene> undo(Scene now) {
            return move(before, undone, now);
        }

        Optional<Scene> redo(Scene now) {
            return move(undone, before, now);
        }

        private Optional<Scene> move(Deque<Scene> from, Deque<Scene> to, Scene now) {
            isOpen = false;
            while (!from.isEmpty()) {
                Scene other = from.pop();
                if (!other.equals(now)) {
                    to.push(now);
                    return Optional.of(other);
                }
            }
            return Optional.empty();
        }
    }
}
