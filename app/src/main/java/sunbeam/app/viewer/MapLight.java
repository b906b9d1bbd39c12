package sunbeam.app.viewer;

import java.util.Optional;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.optics.Direction;

/** Under which light the BRDF map is drawn: at the picked point, or on a skin that faces the viewer. */
final class MapLight {
    // Light at the horizon leaves no radiance to divide by.
    private static final double LOWEST = 0.01;

    private MapLight() {}

    /** Towards the light, tangent frame; empty where that is behind the skin. */
    static Optional<Direction> of(Scene scene, Optional<PickedPoint> picked) {
        Direction light = picked.map(point -> point.light(scene.light().towards()))
                .orElseGet(() -> {
                    Vector3f seen = seen(scene);
                    return new Direction(seen.x, seen.y, seen.z);
                });
        return light.z() < LOWEST ? Optional.empty() : Optional.of(light);
    }

    /** Towards the light in the camera's space: +x right, +y up, +z to the viewer. */
    static Vector3f seen(Scene scene) {
        return scene.view()
                .camera()
                .worldToCamera()
                .transformDirection(scene.light().towards(), new Vector3f());
    }
}
