package sunbeam.app.scene.mesh;

import java.util.Arrays;
import org.joml.Vector3d;

/**
 * Center line of the snake. From the tip of the tail it winds inwards on the ground for more than two turns. In the middle it rises; then
 * it winds back outwards over its own coils, where the head rests. Its parameter is the place along the body: 0 snout, 1 tip of the tail,
 * proportional to length.
 */
final class SnakePath {
    private static final int SAMPLES = 4000;
    private static final int HEAD_SAMPLES = 300;
    /** Approximate length of the body, meters. */
    static final double LENGTH = 1.1;

    private static final double R = SnakeProfile.RADIUS;

    // Distance from the z axis and lift above the ground, in RADIUS, over the angle in turns from the tip of the tail.
    // Neighboring coils touch and overlap by a few percent of their width; the tail and the neck lie apart.
    private final Curve distance = new Curve(
            0, 7.26, 0.06, 6.5, 0.15, 6.1, 0.3, 5.97, 0.45, 5.73, 0.6, 5.46, 0.75, 5.35, 0.9, 5.34, 1.05, 5.03, 1.2,
            4.73, 1.35, 4.37, 1.5, 3.94, 1.65, 3.6, 1.8, 3.5, 1.9, 3.47, 2, 3.25, 2.15, 2.99, 2.3, 2.72, 2.6, 2.05,
            2.75, 1.9, 2.9, 2.2, 3.1, 3.3, 3.3, 5);
    private final Curve lift = new Curve(0, 0, 2.12, 0, 2.4, 0.9, 2.65, 1.7, 3.05, 1.95, 3.3, 1.9);
    // Angle in turns from which on the neck and the head are straight.
    private static final double STRAIGHT = 3.07;
    private static final double HEAD_LENGTH = 5 * R;
    // Place along the body in front of which the center line keeps its height, so that the snout points forwards.
    private static final double CHIN = 0.017;
    // Ratio of the coils' extents along x and y.
    private static final double STRETCH = 1.02;

    private final SnakeProfile profile;
    private final Vector3d[] points = new Vector3d[SAMPLES + 1];
    private final double[] lengths = new double[SAMPLES + 1];

    SnakePath(SnakeProfile profile) {
        this.profile = profile;
        Vector3d neck = spiral(STRAIGHT);
        Vector3d direction = new Vector3d(neck).sub(spiral(STRAIGHT - 1e-4)).normalize();
        for (int i = 0; i <= SAMPLES; i++) {
            double headward = HEAD_LENGTH * (HEAD_SAMPLES - i) / HEAD_SAMPLES;
            points[i] = i < HEAD_SAMPLES
                    ? new Vector3d(neck).fma(headward, direction)
                    : spiral(STRAIGHT * (SAMPLES - i) / (SAMPLES - HEAD_SAMPLES));
            lengths[i] = i == 0 ? 0 : lengths[i - 1] + points[i].distance(points[i - 1]);
        }
    }

    private Vector3d spiral(double turns) {
        double angle = 2 * Math.PI * turns;
        double radius = R * distance.at(turns);
        return new Vector3d(STRETCH * radius * Math.cos(angle), radius * Math.sin(angle), R * lift.at(turns));
    }

    double length() {
        return lengths[SAMPLES];
    }

    /** Returns the center of the cross-section at a place along the body, meters; high enough for the belly to lie on the ground. */
    Vector3d at(double place) {
        double wanted = place * length();
        int found = Arrays.binarySearch(lengths, wanted);
        int low = Math.min(SAMPLES - 1, found < 0 ? -found - 2 : found);
        double t = (wanted - lengths[low]) / (lengths[low + 1] - lengths[low]);
        return points[low]
                .lerp(points[low + 1], t, new Vector3d())
                .add(0, 0, profile.bellyDepth(Math.max(place, CHIN)));
    }
}
