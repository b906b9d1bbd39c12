package sunbeam.app.scene;

import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.PlanRequest;

/**
 * All that determines a picture but its size. Files are named absolutely, so that a scene means the same everywhere in
 * the process; {@link SceneReader} and {@link SceneWriter} turn them into names relative to the scene's folder.
 *
 * @param title for people; may be empty
 * @param mesh a built-in mesh or an absolute OBJ file
 * @param patch the nanostructure: a built-in patch, an absolute descriptor or image
 * @param view from where
 * @param orientation turns the mesh about the centre of its bounding sphere; unit length
 * @param light the light
 * @param texture the body's colours: a built-in texture, {@code none} or an absolute image file
 * @param method how diffraction is computed: full, nmm, pq or gem
 * @param plan what is fixed of the method's plan
 * @param rotatePatch turns the nanostructure in the tangent plane, radians, counter-clockwise seen from outside
 * @param exposure factor of the linear picture, above 0; empty to choose it from the picture
 * @param blend weights of diffracted light and body
 * @param background behind the mesh, not exposed
 * @param origin where patch and plan are written, for complaints
 */
public record Scene(
        String title,
        String mesh,
        PatchRequest patch,
        Viewpoint view,
        Quaternionfc orientation,
        SceneLight light,
        String texture,
        MethodRequest method,
        PlanRequest plan,
        double rotatePatch,
        OptionalDouble exposure,
        Blend blend,
        SceneColor background,
        SceneOrigin origin) {

    /** Copies; rejects rotations and exposures that are none. */
    public Scene {
        if (!(Math.abs(orientation.lengthSquared() - 1) < 1e-3f)) {
            throw new IllegalArgumentException("orientation " + orientation + " has not the length 1");
        }
        orientation = new Quaternionf(orientation);
        if (method.kind() == MethodKind.REFERENCE) {
            throw new IllegalArgumentException(
                    "method reference evaluates single directions; for a mesh use full, nmm, pq or gem");
        }
        if (!Double.isFinite(rotatePatch)) {
            throw new IllegalArgumentException("rotation of the patch by " + rotatePatch + " is no angle");
        }
        if (exposure.isPresent() && !(exposure.getAsDouble() > 0 && Double.isFinite(exposure.getAsDouble()))) {
            throw new IllegalArgumentException("exposure " + exposure.getAsDouble() + " is not above 0");
        }
    }

    /** The same with another mesh. */
    public Scene withMesh(String value) {
        return changed(draft -> draft.mesh = value);
    }

    /** The same with another patch. */
    public Scene withPatch(PatchRequest value) {
        return changed(draft -> {
            draft.patch = value;
            draft.origin = value.equals(patch) ? origin : origin.withoutPatch();
        });
    }

    /** The same from elsewhere. */
    public Scene withView(Viewpoint value) {
        return changed(draft -> draft.view = value);
    }

    /** The same with the mesh turned differently. */
    public Scene withOrientation(Quaternionfc value) {
        return changed(draft -> draft.orientation = value);
    }

    /** The same under another light. */
    public Scene withLight(SceneLight value) {
        return changed(draft -> draft.light = value);
    }

    /** The same with another texture. */
    public Scene withTexture(String value) {
        return changed(draft -> draft.texture = value);
    }

    /** The same with another method and the plan that goes with it. */
    public Scene withMethod(MethodRequest method, PlanRequest plan) {
        return changed(draft -> {
            draft.origin = method.equals(this.method) && plan.equals(this.plan) ? origin : origin.withoutPlan();
            draft.method = method;
            draft.plan = plan;
        });
    }

    /** The same with another plan. */
    public Scene withPlan(PlanRequest value) {
        return changed(draft -> {
            draft.plan = value;
            draft.origin = value.equals(plan) ? origin : origin.withoutPlan();
        });
    }

    /** The same with the nanostructure turned differently, radians. */
    public Scene withRotatePatch(double value) {
        return changed(draft -> draft.rotatePatch = value);
    }

    /** The same with another exposure. */
    public Scene withExposure(OptionalDouble value) {
        return changed(draft -> draft.exposure = value);
    }

    /** The same with other weights. */
    public Scene withBlend(Blend value) {
        return changed(draft -> draft.blend = value);
    }

    private Scene changed(Consumer<Draft> change) {
        Draft draft = new Draft(this);
        change.accept(draft);
        return draft.scene();
    }

    /** A scene's parts while some of them change. */
    private static final class Draft {
        private String title;
        private String mesh;
        private PatchRequest patch;
        private Viewpoint view;
        private Quaternionfc orientation;
        private SceneLight light;
        private String texture;
        private MethodRequest method;
        private PlanRequest plan;
        private double rotatePatch;
        private OptionalDouble exposure;
        private Blend blend;
        private SceneColor background;
        private SceneOrigin origin;

        private Draft(Scene scene) {
            title = scene.title;
            mesh = scene.mesh;
            patch = scene.patch;
            view = scene.view;
            orientation = scene.orientation;
            light = scene.light;
            texture = scene.texture;
            method = scene.method;
            plan = scene.plan;
            rotatePatch = scene.rotatePatch;
            exposure = scene.exposure;
            blend = scene.blend;
            background = scene.background;
            origin = scene.origin;
        }

        private Scene scene() {
            return new Scene(
                    title,
                    mesh,
                    patch,
                    view,
                    orientation,
                    light,
                    texture,
                    method,
                    plan,
                    rotatePatch,
                    exposure,
                    blend,
                    background,
                    origin);
        }
    }
}
