package sunbeam.app.scene.mesh.format;

import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import de.javagl.jgltf.impl.v2.Node;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import sunbeam.precompute.files.InputException;

/**
 * Reader of a glTF 2.0 file's geometry: all meshes of its scene where the scene's nodes place them, with normals, tangents and the texture
 * coordinates of each material's first texture. glTF's y is up, so (x, y, z) becomes (x, -z, y). Points and lines are ignored; skinned and
 * morphed meshes are refused.
 */
final class GltfFile {
    private static final Matrix4d UPRIGHT = new Matrix4d().rotationX(Math.PI / 2);
    private static final int MOST_NODES = 100_000;

    private final GlTF gltf;
    private final GltfBuffers buffers;
    private final GltfPrimitives primitives;

    private GltfFile(GlTF gltf, GltfBuffers buffers) {
        this.gltf = gltf;
        this.buffers = buffers;
        this.primitives = new GltfPrimitives(gltf, new GltfAccessors(gltf, buffers));
    }

    static RawMesh read(Path file) throws IOException {
        GlbFile parts = GlbFile.read(file);
        GlTF gltf = GltfDocument.read(parts.json());
        return new GltfFile(gltf, new GltfBuffers(file, gltf, parts.binary())).mesh();
    }

    private record PendingNode(Integer node, Matrix4d parent) {}

    private RawMesh mesh() throws IOException {
        if (gltf.getScenes() == null) {
            throw new InputException("it has no scene, so nothing is placed; export it again with one");
        }
        List<Integer> roots = buffers.entry(gltf.getScenes(), gltf.getScene() == null ? 0 : gltf.getScene(), "scene")
                .getNodes();
        Deque<PendingNode> waiting = new ArrayDeque<>();
        add(waiting, roots, UPRIGHT);
        Set<Integer> seen = new HashSet<>();
        while (!waiting.isEmpty()) {
            PendingNode next = waiting.pop();
            Node node = buffers.entry(gltf.getNodes(), next.node, "node");
            if (!seen.add(next.node) || seen.size() > MOST_NODES) {
                throw new InputException("node " + next.node + " has two parents, or there are more than " + MOST_NODES
                        + " nodes; export it again");
            }
            Matrix4d place = new Matrix4d(next.parent).mul(local(next.node, node));
            if (node.getMesh() != null) {
                place(next.node, node, place);
            }
            add(waiting, node.getChildren(), place);
        }
        return primitives.mesh();
    }

    private static void add(Deque<PendingNode> waiting, List<Integer> nodes, Matrix4d parent) {
        for (Integer node : nodes == null ? List.<Integer>of() : nodes) {
            waiting.add(new PendingNode(node, parent));
        }
    }

    private Matrix4d local(Integer number, Node node) {
        if (node.getMatrix() != null) {
            return new Matrix4d().set(node.getMatrix());
        }
        float[] move = Objects.requireNonNullElse(node.getTranslation(), node.defaultTranslation());
        float[] turn = Objects.requireNonNullElse(node.getRotation(), node.defaultRotation());
        float[] scale = Objects.requireNonNullElse(node.getScale(), node.defaultScale());
        Quaterniond rotation = new Quaterniond(turn[0], turn[1], turn[2], turn[3]);
        if (rotation.lengthSquared() == 0) {
            throw new InputException("node " + number
                    + " has the rotation [0,0,0,0]; a quaternion of length 1 is needed," + " so export it again");
        }
        return new Matrix4d()
                .translation(move[0], move[1], move[2])
                .rotate(rotation.normalize())
                .scale(scale[0], scale[1], scale[2]);
    }

    private void place(Integer number, Node node, Matrix4d place) throws IOException {
        var mesh = buffers.entry(gltf.getMeshes(), node.getMesh(), "mesh");
        if (node.getSkin() != null) {
            throw new InputException(
                    "node " + number + " is moved by a skeleton; apply its pose and export it without one");
        }
        if (isMoved(node.getWeights() == null ? mesh.getWeights() : node.getWeights())) {
            throw new InputException(
                    "node " + number + " is moved by the weights of targets; apply them and export it again");
        }
        for (MeshPrimitive primitive : mesh.getPrimitives() == null ? List.<MeshPrimitive>of() : mesh.getPrimitives()) {
            primitives.add(primitive, place);
        }
    }

    private static boolean isMoved(List<Float> weights) {
        return weights != null && weights.stream().anyMatch(weight -> weight != 0);
    }
}
