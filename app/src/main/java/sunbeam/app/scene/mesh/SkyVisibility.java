package sunbeam.app.scene.mesh;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.stream.IntStream;
import jrtr.VertexData.BoundingSphere;
import org.joml.Vector3d;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.precompute.files.Checksum;

/**
 * Share of the sky, 0 to 1, visible from a mesh and the ground below it, weighted by the cosine to the normal (ambient occlusion).
 *
 * @param ofGround for squares of the ground, row by row from the least x and y
 */
public record SkyVisibility(float[] ofVertices, float[] ofGround) {
    /** Half the side of the computed ground about the mesh's middle, in radii of the mesh. */
    public static final double GROUND_REACH = 1.6;

    public static final int GROUND_SIDE = 160;

    public static SkyVisibility of(Mesh mesh, BlobCache cache) {
        Checksum checksum = new Checksum().add(mesh.positions()).add(mesh.normals());
        String name = "sky over mesh " + checksum.add(mesh.indices()).hex();
        int size = Float.BYTES * (mesh.vertices() + GROUND_SIDE * GROUND_SIDE);
        byte[] bytes = cache.get(name, size, () -> new DepthMaps(mesh).shares.toBytes(size));
        SkyVisibility visibility = new SkyVisibility(new float[mesh.vertices()], new float[GROUND_SIDE * GROUND_SIDE]);
        ByteBuffer.wrap(bytes).asFloatBuffer().get(visibility.ofVertices).get(visibility.ofGround);
        return visibility;
    }

    private byte[] toBytes(int length) {
        ByteBuffer bytes = ByteBuffer.allocate(length);
        bytes.asFloatBuffer().put(ofVertices).put(ofGround);
        return bytes.array();
    }

    /** Returns the least z, meters. */
    public static double ground(Mesh mesh) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 2; i < mesh.positions().length; i += 3) {
            lowest = Math.min(lowest, mesh.positions()[i]);
        }
        return lowest;
    }

    private static final class DepthMaps {
        private static final int DIRECTIONS = 64;
        private static final int FEW_DIRECTIONS = 12;
        private static final int MANY_TRIANGLES = 200_000;
        private static final int TEXELS = 384;
        // Height of an occluder in radii of the mesh: two texels, so that a surface does not occlude itself.
        private static final double MARGIN = 0.012;
        // Golden angle: a spiral that turns by it covers the sky evenly.
        private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

        private final Mesh mesh;
        private final Vector3d middle;
        private final double radius;
        private final SkyVisibility shares;

        DepthMaps(Mesh mesh) {
            BoundingSphere bounds = mesh.toVertexData().bounds();
            this.mesh = mesh;
            this.middle = new Vector3d(bounds.center());
            this.radius = bounds.radius();
            this.shares = new SkyVisibility(new float[mesh.vertices()], new float[GROUND_SIDE * GROUND_SIDE]);
            int directions = mesh.triangles() > MANY_TRIANGLES ? FEW_DIRECTIONS : DIRECTIONS;
            float[] cosineSums = new float[mesh.vertices()];
            IntStream.range(0, directions)
                    .parallel()
                    .mapToObj(i -> new DepthMap(direction(i, directions)))
                    // Rounded sums of floats depend on the order.
                    .forEachOrdered(map -> map.addVisibility(cosineSums, directions / 2.0));
            for (int i = 0; i < cosineSums.length; i++) {
                shares.ofVertices[i] = cosineSums[i] > 0 ? shares.ofVertices[i] / cosineSums[i] : 0;
            }
        }

        private static Vector3d direction(int number, int count) {
            double z = (number + 0.5) / count;
            double across = Math.sqrt(1 - z * z);
            return new Vector3d(across * Math.cos(GOLDEN_ANGLE * number), across * Math.sin(GOLDEN_ANGLE * number), z);
        }

        /** Depth map; depth grows towards the sky, in meters from the middle. */
        private final class DepthMap {
            private final Vector3d direction;
            private final Vector3d right;
            private final Vector3d up;
            private final float[] depths = new float[TEXELS * TEXELS];

            DepthMap(Vector3d direction) {
                this.direction = direction;
                this.right = new Vector3d(-direction.y, direction.x, 0).normalize();
                this.up = direction.cross(right, new Vector3d());
                Arrays.fill(depths, Float.NEGATIVE_INFINITY);
                double[] x = new double[mesh.vertices()];
                double[] y = new double[mesh.vertices()];
                double[] z = new double[mesh.vertices()];
                for (int i = 0; i < x.length; i++) {
                    Vector3d at = Mesh.vector(mesh.positions(), i).sub(middle);
                    x[i] = texel(at.dot(right));
                    y[i] = texel(at.dot(up));
                    z[i] = at.dot(direction);
                }
                int[] indices = mesh.indices();
                for (int i = 0; i < indices.length; i += 3) {
                    rasterize(x, y, z, indices[i], indices[i + 1], indices[i + 2]);
                }
            }

            private double texel(double distance) {
                return (0.5 + 0.49 * distance / radius) * TEXELS;
            }

            private void rasterize(double[] x, double[] y, double[] z, int a, int b, int c) {
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
                        double weightA = ((x[b] - px) * (y[c] - py) - (x[c] - px) * (y[b] - py)) / area;
                        double weightB = ((x[c] - px) * (y[a] - py) - (x[a] - px) * (y[c] - py)) / area;
                        double weightC = 1 - weightA - weightB;
                        if (weightA >= 0 && weightB >= 0 && weightC >= 0) {
                            int at = row * TEXELS + column;
                            depths[at] =
                                    Math.max(depths[at], (float) (weightA * z[a] + weightB * z[b] + weightC * z[c]));
                        }
                    }
                }
            }

            private boolean sees(Vector3d at) {
                at.sub(middle);
                int column = (int) texel(at.dot(right));
                int row = (int) texel(at.dot(up));
                boolean inside = column >= 0 && column < TEXELS && row >= 0 && row < TEXELS;
                return !inside || depths[row * TEXELS + column] < at.dot(direction) + MARGIN * radius;
            }

            /** @param zSum sum over all directions of their cosine with the ground's normal, z */
            private void addVisibility(float[] cosineSums, double zSum) {
                for (int i = 0; i < cosineSums.length; i++) {
                    Vector3d normal = Mesh.vector(mesh.normals(), i);
                    float cosine = (float) Math.max(0, normal.dot(direction));
                    cosineSums[i] += cosine;
                    if (cosine > 0 && sees(Mesh.vector(mesh.positions(), i).fma(MARGIN * radius, normal))) {
                        shares.ofVertices[i] += cosine;
                    }
                }
                double step = 2 * GROUND_REACH * radius / GROUND_SIDE;
                double height = ground(mesh);
                for (int i = 0; i < shares.ofGround.length; i++) {
                    int row = i / GROUND_SIDE;
                    double x = middle.x + step * (i % GROUND_SIDE + 0.5 - GROUND_SIDE / 2.0);
                    double y = middle.y + step * (row + 0.5 - GROUND_SIDE / 2.0);
                    if (sees(new Vector3d(x, y, height))) {
                        shares.ofGround[i] += (float) (direction.z / zSum);
                    }
                }
            }
        }
    }
}
