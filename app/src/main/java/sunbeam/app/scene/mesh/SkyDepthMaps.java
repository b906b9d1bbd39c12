package sunbeam.app.scene.mesh;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import sunbeam.app.scene.mesh.format.RawMesh;

/** Computes {@link SkyVisibility} by depth maps of the mesh from many directions. */
final class SkyDepthMaps {
    private static final int DIRECTIONS = 64;
    private static final int FEW_DIRECTIONS = 12;
    // Triangles beyond which fewer directions are used.
    private static final int MANY_TRIANGLES = 200_000;
    private static final int SIDE = 384;
    // Least height of an occluder above a point, in radii of the mesh.
    private static final double MARGIN = 0.012;
    private static final double GOLDEN = Math.PI * (3 - Math.sqrt(5));

    private final Mesh mesh;
    private final Vector3d middle;
    private final double radius;
    private final double ground;
    private final float[] ofVertices;
    private final float[] ofGround = new float[SkyVisibility.GROUND_SIDE * SkyVisibility.GROUND_SIDE];

    /** @param radius of a sphere about the middle that holds the mesh */
    SkyDepthMaps(Mesh mesh, Vector3dc middle, double radius) {
        this.mesh = mesh;
        this.middle = new Vector3d(middle);
        this.radius = radius;
        this.ground = SkyVisibility.ground(mesh);
        this.ofVertices = new float[mesh.vertices()];
        int directions = mesh.triangles() > MANY_TRIANGLES ? FEW_DIRECTIONS : DIRECTIONS;
        float[] most = new float[mesh.vertices()];
        double sum = 0;
        for (int i = 0; i < directions; i++) {
            Vector3d direction = direction(i, directions);
            sum += direction.z;
        }
        double all = sum;
        IntStream.range(0, directions)
                .parallel()
                .mapToObj(i -> new Seen(direction(i, directions)))
                // In a fixed order, because sums of floats depend on it.
                .forEachOrdered(seen -> seen.add(most, all));
        for (int i = 0; i < most.length; i++) {
            ofVertices[i] = most[i] > 0 ? ofVertices[i] / most[i] : 0;
        }
    }

    private static Vector3d direction(int number, int count) {
        double z = (number + 0.5) / count;
        double across = Math.sqrt(1 - z * z);
        return new Vector3d(across * Math.cos(GOLDEN * number), across * Math.sin(GOLDEN * number), z);
    }

    SkyVisibility seen() {
        return new SkyVisibility(ofVertices, ofGround);
    }

    /** Depth map of the mesh from one direction. */
    private final class Seen {
        private final Vector3d direction;
        private final Vector3d right;
        private final Vector3d up;
        private final float[] depths = new float[SIDE * SIDE];

        Seen(Vector3d direction) {
            this.direction = direction;
            this.right = new Vector3d(-direction.y, direction.x, 0).normalize();
            this.up = direction.cross(right, new Vector3d());
            Arrays.fill(depths, Float.NEGATIVE_INFINITY);
            double[] x = new double[mesh.vertices()];
            double[] y = new double[mesh.vertices()];
            double[] z = new double[mesh.vertices()];
            for (int i = 0; i < x.length; i++) {
                Vector3d at = RawMesh.vector(mesh.positions(), i).sub(middle);
                x[i] = texel(at.dot(right));
                y[i] = texel(at.dot(up));
                z[i] = at.dot(direction);
            }
            int[] indices = mesh.indices();
            for (int i = 0; i < indices.length; i += 3) {
                fill(x, y, z, indices[i], indices[i + 1], indices[i + 2]);
            }
        }

        private double texel(double distance) {
            return (0.5 + 0.49 * distance / radius) * SIDE;
        }

        private void fill(double[] x, double[] y, double[] z, int a, int b, int c) {
            double area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
            if (area == 0) {
                return;
            }
            int left = (int) Math.ceil(Math.min(x[a], Math.min(x[b], x[c])) - 0.5);
            int right = (int) Math.floor(Math.max(x[a], Math.max(x[b], x[c])) - 0.5);
            int low = (int) Math.ceil(Math.min(y[a], Math.min(y[b], y[c])) - 0.5);
            int high = (int) Math.floor(Math.max(y[a], Math.max(y[b], y[c])) - 0.5);
            for (int row = low; row <= high; row++) {
                for (int column = left; column <= right; column++) {
                    double px = column + 0.5;
                    double py = row + 0.5;
                    double ofA = ((x[b] - px) * (y[c] - py) - (x[c] - px) * (y[b] - py)) / area;
                    double ofB = ((x[c] - px) * (y[a] - py) - (x[a] - px) * (y[c] - py)) / area;
                    double ofC = 1 - ofA - ofB;
                    if (ofA >= 0 && ofB >= 0 && ofC >= 0) {
                        int at = row * SIDE + column;
                        depths[at] = Math.max(depths[at], (float) (ofA * z[a] + ofB * z[b] + ofC * z[c]));
                    }
                }
            }
        }

        private boolean sees(Vector3d at) {
            at.sub(middle);
            int column = (int) texel(at.dot(right));
            int row = (int) texel(at.dot(up));
            boolean inside = column >= 0 && column < SIDE && row >= 0 && row < SIDE;
            return !inside || depths[row * SIDE + column] < at.dot(direction) + MARGIN * radius;
        }

        /** @param all of the cosines of all directions with the ground's normal */
        private void add(float[] most, double all) {
            for (int i = 0; i < most.length; i++) {
                Vector3d normal = RawMesh.vector(mesh.normals(), i);
                float cosine = (float) Math.max(0, normal.dot(direction));
                most[i] += cosine;
                if (cosine > 0 && sees(RawMesh.vector(mesh.positions(), i).fma(MARGIN * radius, normal))) {
                    ofVertices[i] += cosine;
                }
            }
            int side = SkyVisibility.GROUND_SIDE;
            double step = 2 * SkyVisibility.GROUND_REACH * radius / side;
            for (int i = 0; i < ofGround.length; i++) {
                int row = i / side;
                Vector3d at = new Vector3d(
                        middle.x + step * (i % side + 0.5 - side / 2.0),
                        middle.y + step * (row + 0.5 - side / 2.0),
                        ground);
                if (sees(at)) {
                    ofGround[i] += (float) (direction.z / all);
                }
            }
        }
    }
}
