package sunbeam.app.viewer;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Optional;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;

/** By which tables of colours pictures of what moves are drawn in full size: those of the ensemble average by {@code full}. */
final class MovingPlan {
    // Nothing that moves is looked at more closely.
    private static final double FINEST_TOLERANCE = 0.02;

    private MovingPlan() {}

    /** The scene with such tables; none for other methods, whose pictures are others, and for those that have tables themselves. */
    static Optional<Scene> of(Scene scene, Patch patch) {
        SceneMethod seen = scene.method().seeing(patch);
        if (seen.type() != FullMethod.TYPE
                || seen.isThesis()
                || scene.index().isByWavelength()
                || seen.area().average() != Average.ENSEMBLE) {
            return Optional.empty();
        }
        double tolerance = Math.max(FINEST_TOLERANCE, seen.get(TOLERANCE));
        return Optional.of(scene.withMethod(new SceneMethod(
                seen.choices().with(Methods.METHOD, TableMethod.TYPE).with(TOLERANCE, tolerance))));
    }
}
