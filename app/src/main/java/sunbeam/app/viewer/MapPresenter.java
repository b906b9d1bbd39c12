package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.MapView.GratingOrders;
import sunbeam.app.viewer.loop.Stage.MapRequest;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;

/** Presenter of the BRDF map for the picked point, or, if none is picked, for a skin that faces the viewer. On the event thread only. */
final class MapPresenter {
    // Lowest z of the unit vector to the light, about 0.6 degrees above the horizon; below, the radiance vanishes.
    private static final double LOWEST_LIGHT = 0.01;

    private final Viewer viewer;
    private final MapView view;
    // Newest map, null if none is visible, and the displayed one.
    private MapRequest newest;
    private MapRequest displayed;
    // Plan of the displayed map's method, if that map is final.
    private MethodPlan finalMethod;

    MapPresenter(Viewer viewer) {
        this.viewer = viewer;
        view = viewer.window.map;
    }

    /** Marks the map as outdated by the newest scene. */
    void follow(boolean isVisible) {
        newest = null;
        if (!isVisible) {
            return;
        }
        Optional<SkinPoint> picked = viewer.inspector.point();
        Scene scene = viewer.model.litScene();
        Vector3fc toLight = scene.light().towards();
        // In camera space: +x right, +y up, +z to the viewer.
        Vector3f seen = scene.view().camera().worldToCamera().transformDirection(toLight, new Vector3f());
        Direction towards =
                picked.map(point -> point.light(toLight)).orElseGet(() -> new Direction(seen.x, seen.y, seen.z));
        if (towards.z() < LOWEST_LIGHT) {
            view.clear("the light is behind the skin here");
            finalMethod = null;
            return;
        }
        int object = picked.map(point -> point.pick().object()).orElse(scene.current());
        int region = picked.map(point -> point.pick().region()).orElse(0);
        SceneData part =
                viewer.model.loaded().orElseThrow().ofPatch(object, region).get(0);
        Patch patch = part.patch();
        if (displayed != null && !SceneSharing.isSame(displayed.patch(), patch)) {
            view.clear("");
        }
        newest = new MapRequest(towards, object, region, patch);
        boolean isDisplayed = newest.equals(displayed) && SceneSharing.isSame(part.method(), finalMethod);
        if (isDisplayed) {
            newest = displayed;
        } else {
            finalMethod = null;
        }
        view.newest(isDisplayed);
        view.mark(
                picked.map(point -> point.pick().wr()),
                (picked.isPresent() ? "BRDF at the picked point" : "BRDF of a skin that faces you")
                        + (scene.hasEnvironment() ? ", for the brightest light" : ""));
    }

    /** Requests the final map, or a preview unless the newest map is displayed. */
    void request(boolean isFinal) {
        MapRequest request = newest;
        if (request != null && (!SceneSharing.isSame(request, displayed) || (isFinal && finalMethod == null))) {
            MethodPlan method = viewer.model
                    .loaded()
                    .orElseThrow()
                    .ofPatch(request.object(), request.region())
                    .get(0)
                    .method();
            viewer.loop.submit(stage -> stage.map(
                    request,
                    isFinal,
                    viewer.loop::isOutdated,
                    (image, isWhole) ->
                            SwingUtilities.invokeLater(() -> show(request, image, isWhole ? method : null))));
        }
    }

    /** @param method plan of a final map's method, null for another map */
    private void show(MapRequest request, BufferedImage image, MethodPlan method) {
        if (newest != null && !SceneSharing.isSame(newest.patch(), request.patch())) {
            return; // the map of a scan that another has replaced
        }
        displayed = request;
        finalMethod = SceneSharing.isSame(request, newest) ? method : null;
        view.show(image, method == null);
        markOrders();
        if (finalMethod != null) {
            view.newest(true);
        }
    }

    /** Marks the orders of the period, once it is known, on the displayed map. */
    void markOrders() {
        if (displayed == null) {
            return;
        }
        Optional<GratingPeriod> known = viewer.periods.find(displayed.patch());
        List<GratingOrders> orders = known.filter(GratingPeriod::isSeen).stream()
                .flatMap(found -> found.waves().stream())
                .map(wave -> new GratingOrders(wave, displayed.light()))
                .toList();
        String words = known.map(found -> found.isSeen()
                        ? "The period is " + found.estimate() + "."
                        : "No orders are marked: " + found.reason() + ".")
                .orElse("");
        view.orders(orders, words);
    }
}
