package sunbeam.app.scene.mesh.format;

import static de.javagl.jgltf.model.GltfConstants.GL_TRIANGLES;
import static de.javagl.jgltf.model.GltfConstants.GL_TRIANGLE_FAN;
import static de.javagl.jgltf.model.GltfConstants.GL_TRIANGLE_STRIP;

import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.DoubleConsumer;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector2d;
import org.joml.Vector3d;
import sunbeam.app.files.input.InputException;

/**
 * Collects primitives of glTF: triangles, strips and fans, with or without indices. Texture coordinates are those of the
 * material's first texture ({@link GltfTextureCoordinates}).
 */
final class GltfPrimitives {
    // Limit for primitives times placements: a small file can place many primitives many times.
    private static final int MOST_PRIMITIVES = 1_000_000;

    private final Path file;
    private final GlTF gltf;
    private final GltfAccessors accessors;
    private int primitives;
    private final RawMeshBuilder mesh = new RawMeshBuilder();

    GltfPrimitives(Path file, GlTF gltf, GltfAccessors accessors) {
        this.file = file;
        this.gltf = gltf;
        this.accessors = accessors;
    }

    RawMesh mesh() {
        return mesh.build();
    }

    /** Adds a primitive; points, lines and primitives scaled to nothing are ignored. */
    void add(MeshPrimitive primitive, Matrix4d place) throws IOException {
        if (++primitives > MOST_PRIMITIVES) {
            throw new InputException(
                    file + ": its nodes place more than " + MOST_PRIMITIVES + " primitives; join the meshes");
        }
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
        if (mesh.vertices() + (long) vertices > MeshLimits.MOST_ELEMENTS
                || mesh.triangles() + (long) triangles > MeshLimits.MOST_ELEMENTS) {
            throw new InputException(
                    file + ": more than " + MeshLimits.MOST_ELEMENTS + " vertices or triangles; simplify the mesh");
        }
        Offsets offsets = vertices(GltfTextureCoordinates.of(file, gltf, primitive), attributes, vertices, place);
        int[] indices = indices(primitive, corners, vertices);
        boolean mirrored = place.determinant3x3() < 0;
        for (int triangle = 0; triangle < triangles; triangle++) {
            int[] at = corners(mode, triangle);
            int second = at[mirrored ? 2 : 1];
            int third = at[mirrored ? 1 : 2];
            mesh.face(offsets.polygon(indices[at[0]], indices[second], indices[third]));
        }
    }

    /** Returns a triangle's corners; in a strip, every second triangle has two corners exchanged (glTF 2.0, 3.7.2.1). */
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
                throw new InputException(file + ": accessor " + primitive.getIndices() + " names vertex " + index
                        + " but there are " + vertices + "; repair the mesh or export it again");
            }
            indices[i] = (int) index;
        }
        return indices;
    }

    /** Indices of a primitive's first position, texture coordinate and normal in the whole mesh; -1 if it has none. */
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

    private Offsets vertices(
            GltfTextureCoordinates texture, Map<String, Integer> attributes, int vertices, Matrix4d place)
            throws IOException {
        Offsets offsets = new Offsets(
                mesh.vertices(),
                attributes.containsKey(texture.attribute()) ? mesh.textureCoordinates.size() / 2 : -1,
                attributes.containsKey("NORMAL") ? mesh.normals.size() / 3 : -1);
        double[] positions = read(attributes, "POSITION", 3, vertices);
        for (int i = 0; i < vertices; i++) {
            add(mesh.positions::addElement, place.transformPosition(vector(positions, 3, i)));
        }
        if (offsets.textureCoordinate >= 0) {
            double[] coordinates = read(attributes, texture.attribute(), 2, vertices);
            for (int i = 0; i < vertices; i++) {
                Vector2d uv = texture.transform(coordinates[2 * i], coordinates[2 * i + 1]);
                add(mesh.textureCoordinates::add, uv.x);
                // glTF's v grows downwards.
                add(mesh.textureCoordinates::add, 1 - uv.y);
            }
        }
        if (offsets.normal >= 0) {
            Matrix3d normalMatrix = place.normal(new Matrix3d());
            double[] normals = read(attributes, "NORMAL", 3, vertices);
            for (int i = 0; i < vertices; i++) {
                add(mesh.normals::add, normalMatrix.transform(vector(normals, 3, i)));
            }
            tangents(attributes, vertices, place);
        }
        return offsets;
    }

    /** Adds a tangent for each normal, zeros if the primitive has no tangents. */
    private void tangents(Map<String, Integer> attributes, int vertices, Matrix4d place) throws IOException {
        double[] tangents =
                attributes.containsKey("TANGENT") ? read(attributes, "TANGENT", 4, vertices) : new double[4 * vertices];
        double hand = Math.signum(place.determinant3x3());
        for (int i = 0; i < vertices; i++) {
            add(mesh.tangents::add, place.transformDirection(vector(tangents, 4, i)));
            add(mesh.tangents::add, hand * tangents[4 * i + 3]);
        }
    }

    private double[] read(Map<String, Integer> attributes, String name, int components, int vertices)
            throws IOException {
        Integer accessor = attributes.get(name);
        if (accessors.count(accessor) != vertices) {
            throw new InputException(file + ": " + name + " has " + accessors.count(accessor) + " elements of "
                    + vertices + " vertices; export it again");
        }
        return accessors.read(accessor, components);
    }

    private static Vector3d vector(double[] values, int perVertex, int vertex) {
        int at = perVertex * vertex;
        return new Vector3d(values[at], values[at + 1], values[at + 2]);
    }

    private void add(DoubleConsumer list, Vector3d vector) {
        add(list, vector.x);
        add(list, vector.y);
        add(list, vector.z);
    }

    private void add(DoubleConsumer list, double value) {
        if (!MeshLimits.allows(value)) {
            throw new InputException(
                    file + ": a vertex has the number " + value + ", which is " + MeshLimits.BAD_NUMBER);
        }
        list.accept(value);
    }
}
