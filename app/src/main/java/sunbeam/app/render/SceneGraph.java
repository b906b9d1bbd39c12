package sunbeam.app.render;

import java.util.List;
import jrtr.scene.GraphSceneManager;
import jrtr.scene.Light;
import jrtr.scene.Node;
import jrtr.scene.TransformGroup;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;

/** Makes the scene graphs of a scene: of its camera and a model, which one node turns, and of an environment's lights, which another turns. */
final class SceneGraph {
    private SceneGraph() {}

    /**
     * Returns camera and model in world space.
     *
     * @param center point about which the scene's orientation turns the model, world space
     */
    static GraphSceneManager of(Scene scene, Vector3fc center, List<? extends Node> model) {
        Node turned = turned(scene.orientation(), fromCenter(center, model), center);
        return new GraphSceneManager(
                new TransformGroup(new Matrix4f(), scene.view().camera(), turned));
    }

    /** Returns an environment's lights in world space. */
    static GraphSceneManager environment(Scene scene, List<Light> lights) {
        float turn = scene.get(SceneSettings.ENVIRONMENT_ROTATION).floatValue();
        return new GraphSceneManager(new TransformGroup(new Matrix4f().rotationZ(turn), List.copyOf(lights)));
    }

    /** Returns the matrix from the model's space to world space: a rotation about a point. */
    static Matrix4fc modelToWorld(Quaternionfc orientation, Vector3fc center) {
        TransformGroup inner = fromCenter(center, List.of());
        return new GraphSceneManager(turned(orientation, inner, center)).toWorld(inner);
    }

    private static TransformGroup fromCenter(Vector3fc center, List<? extends Node> model) {
        return new TransformGroup(new Matrix4f().translation(center.negate(new Vector3f())), List.copyOf(model));
    }

    private static TransformGroup turned(Quaternionfc orientation, Node about, Vector3fc center) {
        TransformGroup turn = new TransformGroup(new Matrix4f().rotation(orientation), about);
        return new TransformGroup(new Matrix4f().translation(center), turn);
    }
}
