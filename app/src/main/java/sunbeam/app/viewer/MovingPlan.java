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

/** By which tables of colors pictures of what moves are drawn: those of the ensemble average by {@code full}. */
final class MovingPlan {
    // Nothing that moves is looked at more closely.
    private static final double FINEST_TOLERANCE = 0.02;
    // Square metres: 100 um x 100 um have a million DFT bins, some 400 MB of heap, that colors are summed over.
    private static final double LARGEST_AREA = 1e-8;

    private MovingPlan() {}

    /** The scene with such tables; none for other methods, whose pictures are others, and for those that have tables themselves. */
    static Optional<Scene> of(Scene scene, Patch patch) {
        SceneMethod seen = scene.method().seeing(patch);
        if (seen.type() != FullMethod.TYPE
                || seen.isThesis()
                || scene.index().isByWavelength()
                || patch.heights().width() * patch.heights().height() > LARGEST_AREA
                || seen.area().average() != Average.ENSEMBLE) {
            return Optional.empty();
        }
        double tolerance = Math.max(FINEST_TOLERANCE, seen.get(TOLERANCE));
        return Optional.of(scene.withMethod(new SceneMethod(
                seen.choices().with(Methods.METHOD, TableMethod.TYPE).with(TOLERANCE, tolerance))));
    }
}
