package sunbeam.app.viewer.window;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.app.viewer.model.Background;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.pick.PointInspector;
import sunbeam.app.viewer.pick.SkinPoint;
import sunbeam.app.viewer.picture.GratingOrders;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;

/**
 * Presenter of the BRDF map for the picked point, or, if none is picked, for a skin that faces the viewer. Used on the event thread only.
 */
final class MapPresenter {
    // Lowest z of the unit vector to the light, about 0.6 degrees above the horizon; below, the radiance vanishes.
    private static final double LOWEST_LIGHT = 0.01;

    private final ViewerModel model;
    private final ViewerWindow window;
    private final PointInspector inspector;
    private final Background background;
    private boolean isShown = true;
    private Optional<Direction> light = Optional.empty();
    private Patch patch;
    private Optional<GratingPeriod> period = Optional.empty();

    MapPresenter(ViewerModel model, ViewerWindow window, PointInspector inspector, Background background) {
        this.model = model;
        this.window = window;
        this.inspector = inspector;
        this.background = background;
    }

    boolean isShown() {
        return isShown;
    }

    void toggle() {
        isShown = !isShown;
        window.showMap(isShown);
    }

    /** Returns the index of the patch at the picked point; 0 if none is picked. */
    int region() {
        return inspector.point().map(point -> point.pick().region()).orElse(0);
    }

    /**
     * Marks the map as outdated by the newest scene. Returns the direction to the light in the map's tangent frame; empty if the map is
     * hidden or the light is behind the skin.
     */
    Optional<Direction> follow() {
        if (!isShown) {
            return Optional.empty();
        }
        Optional<SkinPoint> picked = inspector.point();
        Vector3f seen = seenLight(model.scene());
        Direction towards = picked.map(
                        point -> point.light(model.scene().light().towards()))
                .orElseGet(() -> new Direction(seen.x, seen.y, seen.z));
        if (towards.z() < LOWEST_LIGHT) {
            window.map().clear("the light is behind the skin here");
            return Optional.empty();
        }
        window.map().newest(false);
        window.map()
                .mark(
                        picked.map(point -> point.pick().wr()),
                        picked.isPresent() ? "BRDF at the picked point" : "BRDF of a skin that faces you");
        return Optional.of(towards);
    }

    /** Returns the direction to the light in camera space: +x right, +y up, +z to the viewer. */
    private static Vector3f seenLight(Scene scene) {
        return scene.view()
                .camera()
                .worldToCamera()
                .transformDirection(scene.light().towards(), new Vector3f());
    }

    void show(BufferedImage image, Optional<Direction> towards, boolean isNewest) {
        light = towards;
        window.map().show(image);
        markOrders();
        if (isNewest) {
            window.map().newest(true);
            findPeriod();
        }
    }

    private Optional<Patch> wantedPatch() {
        return model.loaded().map(loaded -> loaded.ofRegion(region())).stream()
                .flatMap(parts -> parts.stream())
                .findFirst()
                .map(part -> part.patch());
    }

    /** Searches the period of the map's patch in the background, which takes seconds for a scan. */
    @SuppressWarnings("ReferenceEquality") // unchanged parts keep their objects
    private void findPeriod() {
        Patch wanted = wantedPatch().orElse(null);
        if (wanted == null || wanted == patch) {
            return;
        }
        patch = wanted;
        period = Optional.empty();
        background.run(
                () -> GratingPeriod.of(wanted),
                found -> {
                    if (patch == wanted) {
                        period = Optional.of(found);
                        markOrders();
                    }
                },
                window.status()::message);
    }

    @SuppressWarnings("ReferenceEquality") // unchanged parts keep their objects
    private void markOrders() {
        Optional<GratingPeriod> known =
                wantedPatch().filter(wanted -> wanted == patch).flatMap(wanted -> period);
        List<GratingOrders> orders = known.filter(GratingPeriod::isSeen).stream()
                .flatMap(found -> Stream.concat(Stream.of(found.wave()), found.others().stream()))
                .flatMap(wave -> light.map(towards -> new GratingOrders(wave, towards)).stream())
                .toList();
        String words = known.map(found -> found.isSeen()
                        ? "The period is " + found.estimate() + "."
                        : "No orders are marked: " + found.reason() + ".")
                .orElse("");
        window.map().orders(orders, words);
    }
}
