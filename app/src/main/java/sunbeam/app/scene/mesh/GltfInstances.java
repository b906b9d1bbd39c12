package sunbeam.app.scene.mesh;

import de.javagl.jgltf.impl.v2.Node;
import java.io.IOException;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import sunbeam.precompute.files.InputException;

/**
 * Transforms of a glTF node's instances by EXT_mesh_gpu_instancing, which apply before the node's own; a node without the extension has one
 * instance. An array is empty where the file has none.
 */
record GltfInstances(int count, double[] translations, double[] rotations, double[] scales) {
    static final String EXTENSION = "EXT_mesh_gpu_instancing";

    private static final String VISIBILITY = "KHR_node_visibility";

    /** True if KHR_node_visibility hides a node, and with it those below. */
    static boolean isHidden(Integer number, Node node) {
        Object extension = extension(node, VISIBILITY);
        if (extension == null) {
            return false;
        }
        Object visible =
                extension instanceof Map<?, ?> keys && keys.containsKey("visible") ? keys.get("visible") : true;
        if (!(visible instanceof Boolean isVisible)) {
            throw damaged(number, VISIBILITY);
        }
        return !isVisible;
    }

    private static Object extension(Node node, String name) {
        return node.getExtensions() == null ? null : node.getExtensions().get(name);
    }

    private static InputException damaged(Integer number, String extension) {
        return new InputException(
                "node " + number + " has an " + extension + " that cannot be understood; export it again without");
    }

    static GltfInstances of(Integer number, Node node, GltfAccessors accessors, int most) throws IOException {
        Object extension = extension(node, EXTENSION);
        if (extension == null) {
            return new GltfInstances(1, new double[0], new double[0], new double[0]);
        }
        if (!(extension instanceof Map<?, ?> keys) || !(keys.get("attributes") instanceof Map<?, ?> attributes)) {
            throw damaged(number, EXTENSION);
        }
        int count = -1;
        for (String name : new String[] {"TRANSLATION", "ROTATION", "SCALE"}) {
            if (attributes.get(name) instanceof Integer accessor) {
                int own = accessors.count(accessor);
                InputException.refuseIf(
                        own > most || (count >= 0 && own != count),
                        "node " + number + " has " + own + " instances by " + name + ", "
                                + (own > most ? "of at most " + most : "and " + count + " by another attribute")
                                + "; export it again");
                count = own;
            } else if (attributes.containsKey(name)) {
                throw damaged(number, EXTENSION);
            }
        }
        if (count < 0) {
            throw damaged(number, EXTENSION);
        }
        return new GltfInstances(
                count,
                read(attributes, "TRANSLATION", 3, accessors),
                read(attributes, "ROTATION", 4, accessors),
                read(attributes, "SCALE", 3, accessors));
    }

    private static double[] read(Map<?, ?> attributes, String name, int components, GltfAccessors accessors)
            throws IOException {
        return attributes.get(name) instanceof Integer accessor ? accessors.read(accessor, components) : new double[0];
    }

    /** Returns an instance's matrix to the node's space. */
    Matrix4d transform(int instance) {
        Matrix4d matrix = new Matrix4d();
        int three = 3 * instance;
        int four = 4 * instance;
        if (translations.length > 0) {
            matrix.translate(translations[three], translations[three + 1], translations[three + 2]);
        }
        if (rotations.length > 0) {
            Quaterniond turn =
                    new Quaterniond(rotations[four], rotations[four + 1], rotations[four + 2], rotations[four + 3]);
            InputException.refuseIf(
                    !(turn.lengthSquared() > 0),
                    "instance " + instance + " has the rotation [0,0,0,0]; export it again");
            matrix.rotate(turn.normalize());
        }
        if (scales.length > 0) {
            matrix.scale(scales[three], scales[three + 1], scales[three + 2]);
        }
        return matrix;
    }
}
