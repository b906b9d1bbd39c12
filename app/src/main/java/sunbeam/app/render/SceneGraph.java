package sunbeam.app.render;

import java.util.ArrayList;
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

/** Makes the scene graph of a scene: its camera, its lights, and a model, which one node turns. */
final class SceneGraph {
    private SceneGraph() {}

    /**
     * Returns the contents of a scene in world space.
     *
     * @param center point about which the scene's orientation turns the model, world space
     */
    static GraphSceneManager of(Scene scene, Vector3fc center, List<? extends Node> model) {
        List<Node> nodes = new ArrayList<>();
        nodes.add(scene.view().camera());
        scene.lights().forEach(light -> nodes.add(new Light(light.towards(), new Vector3f((float) light.intensity()))));
        nodes.add(turned(scene.orientation(), fromCenter(center, model), center));
        return new GraphSceneManager(new TransformGroup(new Matrix4f(), nodes));
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
