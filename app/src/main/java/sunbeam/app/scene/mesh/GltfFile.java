package sunbeam.app.scene.mesh;

import static de.javagl.jgltf.model.GltfConstants.GL_TRIANGLES;
import static de.javagl.jgltf.model.GltfConstants.GL_TRIANGLE_FAN;
import static de.javagl.jgltf.model.GltfConstants.GL_TRIANGLE_STRIP;

import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.Material;
import de.javagl.jgltf.impl.v2.MaterialPbrMetallicRoughness;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import de.javagl.jgltf.impl.v2.Node;
import de.javagl.jgltf.impl.v2.TextureInfo;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Matrix3d;
import org.joml.Matrix3x2d;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import sunbeam.precompute.files.InputException;

/**
 * Reader of a glTF 2.0 file's geometry: the meshes that its scene's visible nodes place, once or several times, with y up, so that (x, y, z)
 * becomes (x, -z, y). Points and lines are ignored; skinned and morphed meshes are refused.
 */
final class GltfFile {
    private static final Matrix4d UPRIGHT = new Matrix4d().rotationX(Math.PI / 2);
    private static final int MOST_NODES = 100_000;
    // Primitives times placements, of which a small file can have many.
    private static final int MOST_PRIMITIVES = 1_000_000;

    private final GlTF gltf;
    private final GltfAccessors accessors;
    private final Map<Integer, List<Matrix4d>> places = new LinkedHashMap<>();
    private RawMesh.Builder mesh = new RawMesh.Builder();
    private int primitives;

    private GltfFile(Path file, GltfDocument document) {
        this.gltf = document.gltf();
        this.accessors = new GltfAccessors(file, document);
    }

    static Content read(Path file) throws IOException {
        GltfFile read = new GltfFile(file, GltfDocument.read(file));
        RawMesh whole = read.mesh();
        return new Content(whole, read.parts());
    }

    /** All meshes at their places; and each by itself, with its places, if one has several. */
    record Content(RawMesh whole, Map<RawMesh, List<Matrix4d>> parts) {}

    private Map<RawMesh, List<Matrix4d>> parts() throws IOException {
        if (places.values().stream().allMatch(all -> all.size() == 1)) {
            return Map.of();
        }
        Map<RawMesh, List<Matrix4d>> parts = new LinkedHashMap<>();
        for (Integer index : places.keySet()) {
            mesh = new RawMesh.Builder();
            add(gltf.getMeshes().get(index), new Matrix4d());
            parts.put(mesh.build().withoutDegenerate(), places.get(index));
        }
        parts.keySet().removeIf(part -> part.cornerCount() == 0);
        return parts;
    }

    private record PendingNode(Integer node, Matrix4d parent) {}

    private RawMesh mesh() throws IOException {
        InputException.refuseIf(
                gltf.getScenes() == null, "it has no scene, so nothing is placed; export it again with one");
        int scene = Objects.requireNonNullElse(gltf.getScene(), 0);
        Deque<PendingNode> waiting = new ArrayDeque<>();
        add(waiting, accessors.entry(gltf.getScenes(), scene, "scene").getNodes(), UPRIGHT);
        Set<Integer> seen = new HashSet<>();
        while (!waiting.isEmpty()) {
            PendingNode next = waiting.pop();
            Node node = accessors.entry(gltf.getNodes(), next.node, "node");
            if (!seen.add(next.node) || seen.size() > MOST_NODES) {
                throw new InputException(
                        "node " + next.node + " has two parents or contains itself, or there are more than "
                                + MOST_NODES + " nodes; export it again");
            }
            if (GltfInstances.isHidden(next.node, node)) {
                continue;
            }
            Matrix4d place = new Matrix4d(next.parent).mul(local(next.node, node));
            if (node.getMesh() != null) {
                var instances = GltfInstances.of(next.node, node, accessors, MOST_PRIMITIVES);
                for (int i = 0; i < instances.count(); i++) {
                    place(next.node, node, place.mul(instances.transform(i), new Matrix4d()));
                }
            }
            add(waiting, node.getChildren(), place);
        }
        return mesh.build();
    }

    private static void add(Deque<PendingNode> waiting, List<Integer> nodes, Matrix4d parent) {
        for (Integer node : Objects.requireNonNullElse(nodes, List.<Integer>of())) {
            waiting.add(new PendingNode(node, parent));
        }
    }

    private Matrix4d local(Integer number, Node node) {
        if (node.getMatrix() != null) {
            Matrix4d matrix = new Matrix4d().set(node.getMatrix());
            InputException.refuseIf(
                    !matrix.isAffine(), "node " + number + " has a matrix that is not affine; export it again");
            return matrix;
        }
        float[] move = Objects.requireNonNullElse(node.getTranslation(), node.defaultTranslation());
        float[] turn = Objects.requireNonNullElse(node.getRotation(), node.defaultRotation());
        float[] scale = Objects.requireNonNullElse(node.getScale(), node.defaultScale());
        Quaterniond rotation = new Quaterniond(turn[0], turn[1], turn[2], turn[3]);
        if (rotation.lengthSquared() == 0) {
            throw new InputException("node " + number
                    + " has the rotation [0,0,0,0]; a quaternion of length 1 is needed, so export it again");
        }
        return new Matrix4d()
                .translation(move[0], move[1], move[2])
                .rotate(rotation.normalize())
                .scale(scale[0], scale[1], scale[2]);
    }

    private void place(Integer number, Node node, Matrix4d place) throws IOException {
        var placed = accessors.entry(gltf.getMeshes(), node.getMesh(), "mesh");
        InputException.refuseIf(
                node.getSkin() != null,
                "node " + number + " is moved by a skeleton; apply its pose and export it without one");
        List<Float> weights = node.getWeights() == null ? placed.getWeights() : node.getWeights();
        InputException.refuseIf(
                weights != null && weights.stream().anyMatch(weight -> weight != 0),
                "node " + number + " is moved by the weights of targets; apply them and export it again");
        places.computeIfAbsent(node.getMesh(), index -> new ArrayList<>()).add(place);
        add(placed, place);
    }

    private void add(de.javagl.jgltf.impl.v2.Mesh placed, Matrix4d place) throws IOException {
        for (MeshPrimitive primitive : Objects.requireNonNullElse(placed.getPrimitives(), List.<MeshPrimitive>of())) {
            add(primitive, place);
        }
    }

    /** Ignores points, lines and primitives scaled to nothing. */
    private void add(MeshPrimitive primitive, Matrix4d place) throws IOException {
        InputException.refuseIf(
                ++primitives > MOST_PRIMITIVES,
                "its nodes place more than " + MOST_PRIMITIVES + " primitives; join the meshes");
        Map<String, Integer> attributes = primitive.getAttributes();
        if (attributes == null || place.determinant3x3() == 0) {
            return;
        }
        int mode = primitive.getMode() == null ? GL_TRIANGLES : primitive.getMode();
        Integer positions = attributes.get("POSITION");
        if (positions == null || mode < GL_TRIANGLES || mode > GL_TRIANGLE_FAN) {
            return;
        }
        int vertices = accessors.count(positions);
        int corners = primitive.getIndices() == null ? vertices : accessors.count(primitive.getIndices());
        int triangles = mode == GL_TRIANGLES ? corners / 3 : Math.max(0, corners - 2);
        mesh.requireRoom(vertices, triangles);
        Offsets offsets = vertices(TextureCoordinates.of(gltf, primitive), attributes, vertices, place);
        int[] indices = indices(primitive, corners, vertices);
        boolean mirrored = place.determinant3x3() < 0;
        for (int triangle = 0; triangle < triangles; triangle++) {
            int[] at = corners(mode, triangle);
            mesh.addFace(offsets.polygon(indices[at[0]], indices[at[mirrored ? 2 : 1]], indices[at[mirrored ? 1 : 2]]));
        }
    }

    /** In a strip, every second triangle has two corners exchanged (glTF 2.0, 3.7.2.1). */
    private static int[] corners(int mode, int triangle) {
        return switch (mode) {
            case GL_TRIANGLE_STRIP -> new int[] {triangle, triangle + 1 + triangle % 2, triangle + 2 - triangle % 2};
            case GL_TRIANGLE_FAN -> new int[] {triangle + 1, triangle + 2, 0};
            default -> new int[] {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
        };
    }

    private int[] indices(MeshPrimitive primitive, int corners, int vertices) throws IOException {
        double[] given = primitive.getIndices() == null ? null : accessors.read(primitive.getIndices(), 1);
        int[] indices = new int[corners];
        for (int i = 0; i < corners; i++) {
            double index = given == null ? i : given[i];
            if (!(index >= 0 && index < vertices) || index != Math.rint(index)) {
                throw new InputException("accessor " + primitive.getIndices() + " names vertex " + index
                        + " but there are " + vertices + "; repair the mesh or export it again");
            }
            indices[i] = (int) index;
        }
        return indices;
    }

    /** Indices of a primitive's first position, texture coordinate and normal in the mesh, or -1. */
    private record Offsets(int position, int textureCoordinate, int normal) {
        int[] polygon(int... vertices) {
            int[] polygon = new int[9];
            for (int corner = 0; corner < 3; corner++) {
                polygon[3 * corner] = position + vertices[corner];
                polygon[3 * corner + 1] = textureCoordinate < 0 ? -1 : textureCoordinate + vertices[corner];
                polygon[3 * corner + 2] = normal < 0 ? -1 : normal + vertices[corner];
            }
            return polygon;
        }
    }

    private Offsets vertices(TextureCoordinates texture, Map<String, Integer> attributes, int vertices, Matrix4d place)
            throws IOException {
        Offsets offsets = new Offsets(
                mesh.positions(),
                attributes.containsKey(texture.attribute()) ? mesh.textureCoordinates() : -1,
                attributes.containsKey("NORMAL") ? mesh.normals() : -1);
        double[] positions = read(attributes, "POSITION", 3, vertices);
        for (int i = 0; i < vertices; i++) {
            Vector3d position = place.transformPosition(vector(positions, 3, i));
            mesh.addPosition(position.x, position.y, position.z);
        }
        if (offsets.textureCoordinate >= 0) {
            double[] coordinates = read(attributes, texture.attribute(), 2, vertices);
            for (int i = 0; i < vertices; i++) {
                Vector2d uv =
                        texture.transform.transformPosition(new Vector2d(coordinates[2 * i], coordinates[2 * i + 1]));
                mesh.addTextureCoordinate(uv.x, 1 - uv.y);
            }
        }
        if (offsets.normal >= 0) {
            Matrix3d normalMatrix = place.normal(new Matrix3d());
            double hand = Math.signum(place.determinant3x3());
            double[] normals = read(attributes, "NORMAL", 3, vertices);
            double[] tangents = attributes.containsKey("TANGENT")
                    ? read(attributes, "TANGENT", 4, vertices)
                    : new double[4 * vertices];
            for (int i = 0; i < vertices; i++) {
                Vector3d normal = normalMatrix.transform(vector(normals, 3, i));
                mesh.addNormal(normal.x, normal.y, normal.z);
                Vector3d tangent = place.transformDirection(vector(tangents, 4, i));
                mesh.addTangent(tangent.x, tangent.y, tangent.z, hand * tangents[4 * i + 3]);
            }
        }
        return offsets;
    }

    private double[] read(Map<String, Integer> attributes, String name, int components, int vertices)
            throws IOException {
        Integer accessor = attributes.get(name);
        InputException.refuseIf(
                accessors.count(accessor) != vertices,
                name + " has " + accessors.count(accessor) + " elements of " + vertices + " vertices; export it again");
        return accessors.read(accessor, components);
    }

    private static Vector3d vector(double[] values, int perVertex, int vertex) {
        int at = perVertex * vertex;
        return new Vector3d(values[at], values[at + 1], values[at + 2]);
    }

    /** TEXCOORD_n of the material's first texture, with the transform of its extension, whose v grows downwards. */
    private record TextureCoordinates(int set, Matrix3x2d transform) {
        private static final String TRANSFORM = "KHR_texture_transform";

        static TextureCoordinates of(GlTF gltf, MeshPrimitive primitive) {
            List<Material> materials = Objects.requireNonNullElse(gltf.getMaterials(), List.of());
            Integer index = primitive.getMaterial();
            boolean hasMaterial = index != null && index >= 0 && index < materials.size();
            TextureInfo texture = hasMaterial ? firstTexture(materials.get(index)) : null;
            int set = texture == null || texture.getTexCoord() == null ? 0 : texture.getTexCoord();
            Map<String, Object> extensions = texture == null ? null : texture.getExtensions();
            if (extensions == null || !extensions.containsKey(TRANSFORM)) {
                return new TextureCoordinates(set, new Matrix3x2d());
            }
            if (!(extensions.get(TRANSFORM) instanceof Map<?, ?> transform)) {
                throw damaged();
            }
            Object ownSet = transform.containsKey("texCoord") ? transform.get("texCoord") : set;
            Object rotation = transform.containsKey("rotation") ? transform.get("rotation") : 0;
            if (!(ownSet instanceof Integer number) || !(rotation instanceof Number radians)) {
                throw damaged();
            }
            // Counter-clockwise in the picture, as in the extension's first example; its formula has the other sign.
            Matrix3x2d matrix = new Matrix3x2d().translate(pair(transform, "offset", new Vector2d()));
            matrix.rotate(-radians.doubleValue()).scale(pair(transform, "scale", new Vector2d(1)));
            return new TextureCoordinates(number, matrix);
        }

        private static TextureInfo firstTexture(Material material) {
            MaterialPbrMetallicRoughness surface = material.getPbrMetallicRoughness();
            return Stream.of(
                            surface == null ? null : surface.getBaseColorTexture(),
                            material.getNormalTexture(),
                            surface == null ? null : surface.getMetallicRoughnessTexture(),
                            material.getEmissiveTexture())
                    .filter(Objects::nonNull)
                    .findFirst()
                    .orElse(null);
        }

        private static Vector2d pair(Map<?, ?> transform, String key, Vector2d fallback) {
            if (!transform.containsKey(key)) {
                return fallback;
            }
            if (transform.get(key) instanceof List<?> list
                    && list.size() == 2
                    && list.get(0) instanceof Number x
                    && list.get(1) instanceof Number y) {
                return new Vector2d(x.doubleValue(), y.doubleValue());
            }
            throw damaged();
        }

        private static InputException damaged() {
            return new InputException("its " + TRANSFORM + " cannot be understood; export it again without");
        }

        String attribute() {
            return "TEXCOORD_" + set;
        }
    }
}
