package sunbeam.app.scene.mesh;

import java.util.Arrays;
import org.joml.Vector3d;

/**
 * The snake's centre line. From the tip of the tail it winds inwards on the ground in a spiral of two turns and more, rises
 * in the middle, and comes back outwards over its own coils, where the head rests. Parametrised by the place along the
 * body: 0 snout, 1 tip of the tail, proportional to length.
 */
final class SnakePath {
    private static final int SAMPLES = 4000;
    private static final int HEAD_SAMPLES = 300;
    /** About that of the body, metres. */
    static final double LENGTH = 1.3;

    private static final double R = SnakeProfile.RADIUS;

    // Angle in turns from the tip of the tail; distance from the axis and lift above the ground in radii of the body.
    private final Curve distance =
            new Curve(0, 8.8, 0.12, 7.75, 0.4, 6.85, 1.3, 4.95, 2.3, 2.85, 2.6, 2.2, 2.85, 2.15, 3.1, 3.3, 3.3, 5);
    private final Curve lift = new Curve(0, 0, 2.2, 0, 2.85, 1.95, 3.05, 2.15, 3.3, 2.1);
    // From here on the neck and the head are straight.
    private static final double STRAIGHT = 3.07;
    private static final double HEAD_LENGTH = 5 * R;
    // In front of this the centre line keeps its height, so that the snout points forwards and not down.
    private static final double CHIN = 0.017;
    // Coils are longer than wide.
    private static final double STRETCH = 1.14;

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

    /** Length of the body in metres. */
    double length() {
        return lengths[SAMPLES];
    }

    /** The centre of the cross-section, metres; high enough for the belly to lie on the ground where nothing lifts it. */
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
