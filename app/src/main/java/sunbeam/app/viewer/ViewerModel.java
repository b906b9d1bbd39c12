package sunbeam.app.viewer;

import java.util.ArrayList;
import java.util.List;
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
final class ViewerModel {
    /** Told on the event thread. */
    interface Listener {
        /** There is something new to draw, or a control must follow. */
        void changed();

        /** How much of the newest load is done: 0 where it begins. */
        void loading(double share);

        /** Something could not be loaded. */
        void problem(String message);
    }

    /** Loads scenes, in the background. */
    @FunctionalInterface
    interface Loading {
        /**
         * Loads a scene.
         *
         * @param previous what is loaded; null at first
         * @param progress may be told the share that is done
         */
        LoadedScene load(Scene scene, LoadedScene previous, DoubleConsumer progress);
    }

    private final Loading loading;
    private final Background background;
    private Listener listener;
    private Scene wanted;
    private LoadedScene loaded;
    // What was loaded while a newer load was already wanted; stays if that one fails.
    private LoadedScene overtaken;
    private long overtakenLoad;
    private boolean loadsRest;
    private final AtomicLong newestLoad = new AtomicLong();
    // Scenes that are being opened, the first one first.
    private final List<Opening> openings = new ArrayList<>();

    /**
     * A scene that is being opened.
     *
     * @param load its number
     * @param before what was wanted until then
     * @param opened told once it is loaded
     */
    private record Opening(long load, Scene before, Runnable opened) {}

    /** @param scene to begin with */
    ViewerModel(Scene scene, Loading loading, Background background) {
        this.wanted = scene;
        this.loading = loading;
        this.background = background;
    }

    void setListener(Listener value) {
        listener = value;
    }

    /** What the controls show. */
    Scene scene() {
        return wanted;
    }

    /** What can be drawn; empty until the first scene is loaded. */
    Optional<LoadedScene> loaded() {
        return Optional.ofNullable(loaded);
    }

    /** Loads the first scene. */
    void start() {
        load();
    }

    /** Goes over to another scene. */
    void change(UnaryOperator<Scene> change) {
        Scene next = change.apply(wanted);
        boolean loads = loaded == null || !sameParts(next, wanted);
        wanted = next;
        if (loaded != null) {
            loaded = loaded.with(withPartsOf(next, loaded.fine().scene()));
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
    void open(Scene scene, Runnable opened) {
        openings.add(new Opening(newestLoad.get() + 1, wanted, opened));
        wanted = scene;
        if (loaded != null) {
            loaded = loaded.with(withPartsOf(scene, loaded.fine().scene()));
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

    private void accept(long number, LoadedScene result) {
        if (result == null) {
            return;
        }
        if (number != newestLoad.get()) {
            overtaken = result;
            overtakenLoad = number;
            return;
        }
        overtaken = null;
        loadsRest = false;
        loaded = result.with(withPartsOf(wanted, result.fine().scene()));
        endOpenings(number);
        listener.changed();
        if (!loaded.isWhole() && !loaded.waitsForColors()) {
            load();
        }
    }

    /** Loads what pictures can do without, where that was left for later. */
    void loadRest() {
        if (loaded != null && !loaded.isWhole() && !loadsRest) {
            loadsRest = true;
            load();
        }
    }

    private void refuse(long number, String message) {
        // An older load's problem is the newer one's too, or else of no interest any more.
        if (number != newestLoad.get()) {
            return;
        }
        long kept = overtaken == null ? 0 : overtakenLoad;
        // What was changed since a scene was opened that did not load goes with it.
        Scene base = openings.stream()
                .filter(opening -> opening.load > kept)
                .findFirst()
                .map(Opening::before)
                .orElse(wanted);
        if (overtaken != null) {
            loaded = overtaken;
            overtaken = null;
        }
        if (loaded != null) {
            wanted = withPartsOf(base, loaded.fine().scene());
            loaded = loaded.with(wanted);
        }
        endOpenings(kept);
        listener.changed();
        listener.problem(message);
    }

    /** Tells the last scene that was opened by a load. */
    private void endOpenings(long load) {
        List<Opening> all = List.copyOf(openings);
        openings.clear();
        all.stream()
                .filter(opening -> opening.load <= load)
                .reduce((earlier, later) -> later)
                .ifPresent(opening -> opening.opened.run());
    }

    private static boolean sameParts(Scene one, Scene other) {
        return one.mesh().equals(other.mesh())
                && one.patch().equals(other.patch())
                && one.texture().equals(other.texture())
                && one.method().method().equals(other.method().method())
                && one.index().sharesSpectrum(other.index());
    }

    /** The one scene's light, camera and weights with the other's mesh, patch, texture, method and index by wavelength. */
    private static Scene withPartsOf(Scene scene, Scene parts) {
        Scene lit = scene.index().sharesSpectrum(parts.index()) ? scene : scene.withIndex(parts.index());
        return lit.withMesh(parts.mesh())
                .withPatch(parts.patch())
                .withTexture(parts.texture())
                .withMethod(parts.method());
    }
}
