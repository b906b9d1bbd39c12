package sunbeam.app.scene.mesh;

import org.joml.Vector3d;

/**
 * Triangles as an OBJ file has them: each corner with its own three indices.
 *
 * @param positions 3 per position
 * @param textureCoordinates 2 per texture coordinate
 * @param normals 3 per normal, of any length
 * @param corners 3 per corner, so 9 per triangle: position, texture coordinate or -1, normal or -1
 */
record RawMesh(float[] positions, float[] textureCoordinates, float[] normals, int[] corners) {

    int cornerCount() {
        return corners.length / 3;
    }

    int position(int corner) {
        return corners[3 * corner];
    }

    int textureCoordinate(int corner) {
        return corners[3 * corner + 1];
    }

    int normal(int corner) {
        return corners[3 * corner + 2];
    }

    Vector3d positionOf(int corner) {
        return vector(positions, position(corner));
    }

    /** Normal of the triangle that begins at this corner, as long as twice its area. */
    Vector3d areaNormal(int first) {
        Vector3d origin = positionOf(first);
        Vector3d one = positionOf(first + 1).sub(origin);
        Vector3d other = positionOf(first + 2).sub(origin);
        return one.cross(other);
    }

    static Vector3d vector(float[] values, int index) {
        return new Vector3d(values[3 * index], values[3 * index + 1], values[3 * index + 2]);
    }
}
