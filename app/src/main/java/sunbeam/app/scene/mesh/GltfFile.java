package sunbeam.app.scene.mesh;

import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import de.javagl.jgltf.impl.v2.Node;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
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
 * Reader of a glTF 2.0 file's geometry: the meshes that its scene's nodes place, with y up, so that (x, y, z) becomes (x, -z, y). Points
 * and lines are ignored; skinned and morphed meshes are refused.
 */
final class GltfFile {
    static final String MAGIC = "glTF";
    private static final int MAGIC_NUMBER = 0x46546C67;
    // The parsed tree of a longer text, with buffers as base64, would fill the heap.
    private static final int MOST_JSON_BYTES = 24 << 20;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;
    // "JSON" and "BIN\0" in little-endian ASCII.
    private static final int JSON = 0x4E4F534A;
    private static final int BINARY = 0x004E4942;
    private static final Matrix4d UPRIGHT = new Matrix4d().rotationX(Math.PI / 2);
    private static final int MOST_NODES = 100_000;

    private final GlTF gltf;
    private final GltfAccessors accessors;
    private final GltfPrimitives primitives;

    private GltfFile(GlTF gltf, GltfAccessors accessors) {
        this.gltf = gltf;
        this.accessors = accessors;
        this.primitives = new GltfPrimitives(gltf, accessors);
    }

    static RawMesh read(Path file) throws IOException {
        ByteBuffer all = map(file);
        if (all.limit() < HEADER_BYTES || all.getInt(0) != MAGIC_NUMBER) {
            return read(file, text(all, 0, all.limit()), ByteBuffer.allocate(0));
        }
        InputException.refuseIf(
                all.getInt(4) != 2,
                "it is glTF of version " + Integer.toUnsignedLong(all.getInt(4)) + "; export it as glTF 2.0");
        int first = HEADER_BYTES + CHUNK_HEADER_BYTES;
        int json = chunk(all, HEADER_BYTES, JSON, "JSON");
        int next = first + json;
        int binary = next + CHUNK_HEADER_BYTES > all.limit() ? 0 : chunk(all, next, BINARY, "binary");
        return read(file, text(all, first, json), slice(all, binary == 0 ? 0 : next + CHUNK_HEADER_BYTES, binary));
    }

    private static RawMesh read(Path file, byte[] json, ByteBuffer binary) throws IOException {
        GlTF gltf = GltfDocument.read(json);
        return new GltfFile(gltf, new GltfAccessors(file, gltf, binary)).mesh();
    }

    static ByteBuffer map(Path file) throws IOException {
        MeshSource.requireSize(file);
        try (FileChannel channel = FileChannel.open(file)) {
            return channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size()).order(ByteOrder.LITTLE_ENDIAN);
        }
    }

    static ByteBuffer slice(ByteBuffer buffer, int offset, int length) {
        return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static int chunk(ByteBuffer all, int at, int kind, String name) {
        if (at + CHUNK_HEADER_BYTES > all.limit() || all.getInt(at + 4) != kind) {
            throw new InputException("there is no " + name + " chunk at byte " + at + "; export it again");
        }
        int length = all.getInt(at);
        if (length < 0 || length > all.limit() - at - CHUNK_HEADER_BYTES) {
            throw new InputException("the " + name + " chunk has " + Integer.toUnsignedLong(length)
                    + " bytes, more than the file; copy or export it again");
        }
        return length;
    }

    private static byte[] text(ByteBuffer all, int offset, int length) {
        InputException.refuseIf(
                length > MOST_JSON_BYTES,
                "its JSON has " + length + " bytes; at most " + MOST_JSON_BYTES + " can be used, so export it as .glb");
        byte[] text = new byte[length];
        all.get(offset, text);
        return text;
    }

    private record PendingNode(Integer node, Matrix4d parent) {}

    private RawMesh mesh() throws IOException {
        InputException.refuseIf(
                gltf.getScenes() == null, "it has no scene, so nothing is placed; export it again with one");
        List<Integer> roots = accessors
                .entry(gltf.getScenes(), gltf.getScene() == null ? 0 : gltf.getScene(), "scene")
                .getNodes();
        Deque<PendingNode> waiting = new ArrayDeque<>();
        add(waiting, roots, UPRIGHT);
        Set<Integer> seen = new HashSet<>();
        while (!waiting.isEmpty()) {
            PendingNode next = waiting.pop();
            Node node = accessors.entry(gltf.getNodes(), next.node, "node");
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
        var mesh = accessors.entry(gltf.getMeshes(), node.getMesh(), "mesh");
        InputException.refuseIf(
                node.getSkin() != null,
                "node " + number + " is moved by a skeleton; apply its pose and export it without one");
        List<Float> weights = node.getWeights() == null ? mesh.getWeights() : node.getWeights();
        InputException.refuseIf(
                weights != null && weights.stream().anyMatch(weight -> weight != 0),
                "node " + number + " is moved by the weights of targets; apply them and export it again");
        for (MeshPrimitive primitive : mesh.getPrimitives() == null ? List.<MeshPrimitive>of() : mesh.getPrimitives()) {
            primitives.add(primitive, place);
        }
    }
}
