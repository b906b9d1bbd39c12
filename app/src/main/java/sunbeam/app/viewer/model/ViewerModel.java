package sunbeam.app.viewer.model;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.DoubleConsumer;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;
import sunbeam.app.scene.Scene;

/**
 * The scene that the user sees and changes. Belongs to the event thread. Changes that need loading are loaded in the
 * background while the old parts stay on screen; if that fails, they stay for good.
 */
public final class ViewerModel {
    /** Told on the event thread. */
    public interface Listener {
        /** There is something new to draw, or a control must follow. */
        void changed();

        /** How much of the newest load is done: 0 where it begins. */
        void loading(double share);

        /** Something could not be loaded. */
        void problem(String message);
    }

    /** Loads scenes, in the background. */
    @FunctionalInterface
    public interface Loading {
        /** Loads a scene, after the previous one, null at first, whose parts it keeps; may tell the share that is done. */
        LoadedScene load(Scene scene, LoadedScene previous, DoubleConsumer progress);
    }

    private final Loading loading;
    private final Background background;
    private Listener listener;
    private Scene wanted;
    private LoadedScene loaded;
    private final AtomicLong newestLoad = new AtomicLong();
    private Optional<Opening> opening = Optional.empty();
    private final History history = new History();

    /**
     * A scene that is being opened.
     *
     * @param load its number
     * @param before what was wanted until then
     * @param opened told once it is loaded
     */
    private record Opening(long load, Scene before, Runnable opened) {}

    public ViewerModel(Scene scene, Loading loading, Background background) {
        this.wanted = scene;
        this.loading = loading;
        this.background = background;
    }

    public void setListener(Listener value) {
        listener = value;
    }

    /** What the controls show. */
    public Scene scene() {
        return wanted;
    }

    /** What can be drawn; empty until the first scene is loaded. */
    public Optional<LoadedScene> loaded() {
        return Optional.ofNullable(loaded);
    }

    public void start() {
        load();
    }

    public void change(UnaryOperator<Scene> change) {
        Scene next = change.apply(wanted);
        history.changed(wanted, next);
        set(next);
    }

    /** Goes over to another scene as a part of the last step. */
    public void amend(UnaryOperator<Scene> change) {
        set(change.apply(wanted));
    }

    private void set(Scene next) {
        boolean loads = loaded == null || !next.sharesParts(wanted);
        wanted = next;
        if (loaded != null) {
            loaded = loaded.with(next.withPartsOf(loaded.fine().scene()));
        }
        if (loads) {
            load();
        }
        listener.changed();
    }

    /**
     * Goes over to a scene as a whole: if any part of it cannot be loaded, all goes back to how it was.
     *
     * @param opened told once it is loaded
     */
    public void open(Scene scene, Runnable opened) {
        history.opened(wanted, scene);
        load(scene, opened);
    }

    /** A hand takes hold of something, or lets go of it: what changes in between is one step. */
    public void hand(boolean holds) {
        history.hand(holds);
    }

    public void undo() {
        history.undo(wanted).ifPresent(this::goTo);
    }

    public void redo() {
        history.redo(wanted).ifPresent(this::goTo);
    }

    private void goTo(Scene scene) {
        if (scene.sharesParts(wanted)) {
            set(scene);
        } else {
            load(scene, () -> {});
        }
    }

    private void load(Scene scene, Runnable opened) {
        Scene before = opening.map(Opening::before).orElse(wanted);
        opening = Optional.of(new Opening(newestLoad.get() + 1, before, opened));
        wanted = scene;
        if (loaded != null) {
            loaded = loaded.with(scene.withPartsOf(loaded.fine().scene()));
        }
        load();
        listener.changed();
    }

    private void load() {
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
                // A load that is out of date before it begins is left out.
                () -> number == newestLoad.get() ? loading.load(scene, previous, progress) : null,
                result -> accept(number, result),
                message -> refuse(number, message));
    }

    /** What a newer load overtakes is shown until that one is there. */
    private void accept(long number, LoadedScene result) {
        if (result == null) {
            return;
        }
        loaded = result.with(wanted.withPartsOf(result.fine().scene()));
        opening.filter(done -> done.load() <= number).ifPresent(done -> {
            opening = Optional.empty();
            done.opened().run();
        });
        listener.changed();
    }

    private void refuse(long number, String message) {
        // An older load's problem is the newer one's too, or else of no interest any more.
        if (number != newestLoad.get()) {
            return;
        }
        if (loaded != null) {
            // What was changed since a scene was opened that did not load goes with it.
            Scene base = opening.map(Opening::before).orElse(wanted);
            wanted = base.withPartsOf(loaded.fine().scene());
            loaded = loaded.with(wanted);
        }
        opening = Optional.empty();
        listener.changed();
        listener.problem(message);
    }
}
