package sunbeam.app.scene.mesh;

import jrtr.VertexData;
import org.joml.Vector3d;

/**
 * Triangle mesh with normals, tangents and texture coordinates. Arrays are shared, not copied; they must not be changed.
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

    /** Returns a vector of an array with three numbers for each. */
    static Vector3d vector(float[] values, int index) {
        return new Vector3d(values[3 * index], values[3 * index + 1], values[3 * index + 2]);
    }

    /**
     * Returns the engine's vertex data, with the visible share of the sky as the magnitude of the tangents' w.
     *
     * @param sky visible share of the sky of each vertex, 0 to 1
     */
    public VertexData toVertexData(float[] sky) {
        float[] tangentsWithSky = tangents.clone();
        for (int i = 0; i < sky.length; i++) {
            // A magnitude above 0 keeps the sign, which is the handedness.
            tangentsWithSky[4 * i + 3] *= Math.max(sky[i], 1e-3f);
        }
        return new VertexData(positions, normals, tangentsWithSky, textureCoordinates, indices);
    }

    public VertexData toVertexData() {
        return new VertexData(positions, normals, tangents, textureCoordinates, indices);
    }
}
