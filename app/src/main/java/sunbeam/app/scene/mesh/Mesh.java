package sunbeam.app.scene.mesh;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import jrtr.VertexData;
import org.joml.Matrix3f;
import org.joml.Matrix4fc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3f;

/**
 * Triangle mesh. Arrays are shared; they must not be changed.
 *
 * @param positions 3 per vertex, meters, z up
 * @param normals 3 per vertex, unit length, outwards
 * @param tangents 4 per vertex: unit vector along the texture's u, orthogonal to the normal, then the handedness h, 1 or -1; the bitangent
 *     is h (normal x tangent)
 * @param textureCoordinates 2 per vertex: u, v
 * @param indices 3 per triangle, counter-clockwise seen from outside
 * @param closed whether the mesh is known to enclose a body, so that only fronts of triangles are visible from outside
 */
public record Mesh(
        float[] positions,
        float[] normals,
        float[] tangents,
        float[] textureCoordinates,
        int[] indices,
        boolean closed) {

    public int vertices() {
        return positions.length / 3;
    }

    public int triangles() {
        return indices.length / 3;
    }

    /** Returns the side along x (0), y or z of the box around the mesh, in meters. */
    public double side(int axis) {
        var ends = IntStream.range(0, vertices())
                .mapToDouble(vertex -> positions[3 * vertex + axis])
                .summaryStatistics();
        return ends.getMax() - ends.getMin();
    }

    static Vector3d vector(float[] values, int index) {
        return new Vector3d(values[3 * index], values[3 * index + 1], values[3 * index + 2]);
    }

    /** Joins meshes at their places, without tangents and texture coordinates if there are several. */
    public static Mesh joined(List<MeshSource.Part> parts) {
        if (parts.size() == 1 && (parts.get(0).place().properties() & Matrix4fc.PROPERTY_IDENTITY) != 0) {
            return parts.get(0).mesh();
        }
        List<Mesh> meshes = parts.stream().map(MeshSource.Part::mesh).toList();
        int vertices = meshes.stream().mapToInt(Mesh::vertices).sum();
        float[] positions = new float[3 * vertices];
        float[] normals = new float[3 * vertices];
        int[] indices =
                new int[meshes.stream().mapToInt(mesh -> mesh.indices.length).sum()];
        Vector3f vector = new Vector3f();
        int vertex = 0;
        int corner = 0;
        for (MeshSource.Part part : parts) {
            Mesh mesh = part.mesh();
            Matrix3f toNormal = part.place().normal(new Matrix3f());
            boolean isMirrored = part.place().determinant3x3() < 0;
            for (int j = 0; j < mesh.indices.length; j++) {
                // A mirror exchanges clockwise and counter-clockwise.
                indices[corner++] = vertex + mesh.indices[isMirrored ? j + 2 - 2 * (j % 3) : j];
            }
            for (int j = 0; j < mesh.positions.length; j += 3) {
                vector.set(mesh.positions[j], mesh.positions[j + 1], mesh.positions[j + 2]);
                put(part.place().transformPosition(vector), positions, 3 * vertex + j);
                vector.set(mesh.normals[j], mesh.normals[j + 1], mesh.normals[j + 2]);
                put(toNormal.transform(vector).normalize(), normals, 3 * vertex + j);
            }
            vertex += mesh.vertices();
        }
        boolean closed = meshes.stream().allMatch(Mesh::closed);
        return new Mesh(positions, normals, new float[0], new float[0], indices, closed);
    }

    private static void put(Vector3f vector, float[] values, int at) {
        values[at] = vector.x;
        values[at + 1] = vector.y;
        values[at + 2] = vector.z;
    }

    /** Returns vertex data with the visible share of the sky (0 to 1 for each vertex) as the magnitude of the tangents' w. */
    public VertexData toVertexData(float[] sky) {
        float[] tangentsWithSky = tangents.clone();
        for (int i = 0; i < sky.length; i++) {
            // Above 0, since the sign is the handedness.
            tangentsWithSky[4 * i + 3] *= Math.max(sky[i], 1e-3f);
        }
        return new VertexData(positions, normals, tangentsWithSky, textureCoordinates, indices);
    }

    public VertexData toVertexData() {
        return new VertexData(positions, normals, tangents, textureCoordinates, indices);
    }

    /** Collects a generated mesh, with right-handed tangent frames. */
    static final class Builder {
        private final FloatList positions = new FloatList();
        private final FloatList normals = new FloatList();
        private final FloatList tangents = new FloatList();
        private final FloatList textureCoordinates = new FloatList();
        private final IntStream.Builder indices = IntStream.builder();

        record Point(Vector3dc position, Vector3dc normal, Vector3dc tangent) {}

        int vertex(Point point, double u, double v) {
            int number = positions.size() / 3;
            add(positions, point.position);
            add(normals, point.normal);
            add(tangents, point.tangent);
            tangents.add(1);
            textureCoordinates.add(u);
            textureCoordinates.add(v);
            return number;
        }

        private static void add(FloatList list, Vector3dc vector) {
            list.add(vector.x());
            list.add(vector.y());
            list.add(vector.z());
        }

        void triangle(int first, int second, int third) {
            indices.add(first);
            indices.add(second);
            indices.add(third);
        }

        /** Surface over (u, v) in [0, 1]; normal = tangent x (direction of growing v). */
        interface Surface {
            Point at(double u, double v);
        }

        /** Samples a surface over all v. */
        static Mesh grid(int columns, int rows, boolean closed, Surface surface) {
            Builder mesh = new Builder();
            mesh.grid(columns, rows, 0, 1, surface);
            return mesh.build(closed);
        }

        /** Adds a part of a surface, from one v to another. A cell with an edge of length 0 gets one triangle. */
        void grid(int columns, int rows, double from, double to, Surface surface) {
            Vector3dc[] places = new Vector3dc[(rows + 1) * (columns + 1)];
            int first = positions.size() / 3;
            for (int row = 0; row <= rows; row++) {
                for (int column = 0; column <= columns; column++) {
                    double u = (double) column / columns;
                    double v = from + (to - from) * row / rows;
                    Point point = surface.at(u, v);
                    places[vertex(point, u, v) - first] = point.position();
                }
            }
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    int below = row * (columns + 1) + column;
                    int above = below + columns + 1;
                    if (places[below].distanceSquared(places[below + 1]) > 0) {
                        triangle(first + below, first + below + 1, first + above + 1);
                    }
                    if (places[above].distanceSquared(places[above + 1]) > 0) {
                        triangle(first + below, first + above + 1, first + above);
                    }
                }
            }
        }

        Mesh build(boolean closed) {
            float[] uv = textureCoordinates.toArray();
            int[] corners = indices.build().toArray();
            return new Mesh(positions.toArray(), normals.toArray(), tangents.toArray(), uv, corners, closed);
        }
    }

    static final class FloatList {
        private float[] values = new float[64];
        private int size;

        void add(double value) {
            if (size == values.length) {
                values = Arrays.copyOf(values, size + size / 2);
            }
            values[size++] = (float) value;
        }

        int size() {
            return size;
        }

        float[] toArray() {
            return Arrays.copyOf(values, size);
        }
    }
}
