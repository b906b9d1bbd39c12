package sunbeam.app.scene.mesh.format;

import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;

/**
 * Triangles of a file: each corner has its own three indices.
 *
 * @param positions 3 per position, in double precision
 * @param textureCoordinates 2 per texture coordinate
 * @param normals 3 per normal, of any length
 * @param tangents empty, or 4 per normal: a vector x, y, z of any length (0 if the normal has no tangent), then the handedness, negative
 *     for left-handed
 * @param corners 3 per corner, so 9 per triangle: position, texture coordinate or -1, normal or -1
 */
public record RawMesh(
        double[] positions, float[] textureCoordinates, float[] normals, float[] tangents, int[] corners) {
    // Ratio of a triangle's height to its longest side below which the height is due to rounding.
    private static final double THINNEST = 1e-9;
    // Ratio of the distance from the origin to the mesh's longest side above which the mesh is far; a float32 has
    // steps of 6e-8 of the distance.
    private static final double FAR = 500;

    public int cornerCount() {
        return corners.length / 3;
    }

    public int position(int corner) {
        return corners[3 * corner];
    }

    public int textureCoordinate(int corner) {
        return corners[3 * corner + 1];
    }

    public int normal(int corner) {
        return corners[3 * corner + 2];
    }

    /** True if a normal has a tangent; a negative index is no normal. */
    public boolean hasTangent(int normal) {
        return normal >= 0 && tangents.length > 0 && tangentOf(normal).length() > 0;
    }

    public Vector3d tangentOf(int normal) {
        return new Vector3d(tangents[4 * normal], tangents[4 * normal + 1], tangents[4 * normal + 2]);
    }

    /** Returns the handedness of a normal's tangent, 1 or -1. */
    public int hand(int normal) {
        return tangents[4 * normal + 3] < 0 ? -1 : 1;
    }

    public Vector3d positionOf(int corner) {
        int at = 3 * position(corner);
        return new Vector3d(positions[at], positions[at + 1], positions[at + 2]);
    }

    /** Returns the normal of the triangle whose first corner is given, with twice the triangle's area as its length. */
    public Vector3d areaNormal(int first) {
        Vector3d origin = positionOf(first);
        Vector3d one = positionOf(first + 1).sub(origin);
        Vector3d other = positionOf(first + 2).sub(origin);
        return one.cross(other);
    }

    public static Vector3d vector(float[] values, int index) {
        return new Vector3d(values[3 * index], values[3 * index + 1], values[3 * index + 2]);
    }

    public RawMesh inMeters(MeshUnit unit) {
        double[] scaled = positions.clone();
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] *= unit.meters();
        }
        return new RawMesh(scaled, textureCoordinates, normals, tangents, corners);
    }

    /**
     * Returns the center of the bounding box of a mesh so far from the origin that float32 coordinates would change its shape by 3e-5 of
     * its longest side or more; else empty.
     */
    public Optional<Vector3d> farCenter() {
        Vector3d least = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d most = new Vector3d(Double.NEGATIVE_INFINITY);
        for (int corner = 0; corner < cornerCount(); corner++) {
            Vector3d position = positionOf(corner);
            least.min(position);
            most.max(position);
        }
        Vector3d size = most.sub(least, new Vector3d());
        Vector3d center = least.add(most).mul(0.5);
        boolean isFar = center.length() > FAR * size.get(size.maxComponent());
        return isFar ? Optional.of(center) : Optional.empty();
    }

    public RawMesh centered(Vector3d center) {
        double[] moved = positions.clone();
        for (int i = 0; i < moved.length; i++) {
            moved[i] -= center.get(i % 3);
        }
        return new RawMesh(moved, textureCoordinates, normals, tangents, corners);
    }

    /** Returns the mesh without triangles of no area, which have no normal and are invisible. */
    public RawMesh withoutDegenerate() {
        IntStream.Builder remaining = IntStream.builder();
        for (int first = 0; first < cornerCount(); first += 3) {
            if (!isDegenerate(first)) {
                for (int i = 3 * first; i < 3 * first + 9; i++) {
                    remaining.add(corners[i]);
                }
            }
        }
        return new RawMesh(
                positions,
                textureCoordinates,
                normals,
                tangents,
                remaining.build().toArray());
    }

    private boolean isDegenerate(int first) {
        Vector3d a = positionOf(first);
        Vector3d b = positionOf(first + 1);
        Vector3d c = positionOf(first + 2);
        double longest = Math.max(a.distanceSquared(b), Math.max(b.distanceSquared(c), c.distanceSquared(a)));
        return areaNormal(first).length() <= THINNEST * longest;
    }

    /**
     * Returns the mesh with texture coordinates projected from above, x to u and y to v, scaled so that the longer side spans 0 to 1.
     * Tangents then follow x.
     */
    public RawMesh withPlanarCoordinates() {
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int corner = 0; corner < cornerCount(); corner++) {
            for (int i = 0; i < 2; i++) {
                double value = positions[3 * position(corner) + i];
                least[i] = Math.min(least[i], value);
                most[i] = Math.max(most[i], value);
            }
        }
        double side = Math.max(most[0] - least[0], most[1] - least[1]);
        double scale = side > 0 ? 1 / side : 1;
        int count = positions.length / 3;
        float[] coordinates = new float[2 * count];
        for (int position = 0; position < count; position++) {
            for (int i = 0; i < 2; i++) {
                coordinates[2 * position + i] = (float) ((positions[3 * position + i] - least[i]) * scale);
            }
        }
        int[] planar = corners.clone();
        for (int corner = 0; corner < cornerCount(); corner++) {
            planar[3 * corner + 1] = position(corner);
        }
        return new RawMesh(positions, coordinates, normals, tangents, planar);
    }
}
